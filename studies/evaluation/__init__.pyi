from .evaluation_report import write_evaluation as write_evaluation
from .full_evaluation import evaluate_fully as evaluate_fully
from .headline import (
    Headline as Headline,
    HeadlineTouches as HeadlineTouches,
    evaluate_headlines as evaluate_headlines,
)
from .localizer_evaluation import evaluate_localizer as evaluate_localizer
from .localizer_training import TrainedLocalizer as TrainedLocalizer, train_localizer as train_localizer
from .training_files import TOUCHES as TOUCHES, write_training_files as write_training_files
