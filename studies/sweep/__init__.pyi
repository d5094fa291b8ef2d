from .one_design import design_metrics as design_metrics
from .plan import Plan as Plan, plan_sweep as plan_sweep
from .progress import Progress as Progress
from .results import Sweep as Sweep, open_sweep as open_sweep
from .run import SweepError as SweepError, run_sweep as run_sweep
from .summary import Summary as Summary
from .workers import Workers as Workers, open_workers as open_workers
