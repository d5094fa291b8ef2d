from .full_evaluation import evaluate_fully as evaluate_fully
from .report import write_evaluation as write_evaluation
from .training_files import TOUCHES as TOUCHES, write_training_files as write_training_files
