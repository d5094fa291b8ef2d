from .measured import Measured as Measured, points_in_words as points_in_words
from .measuring import Drawn as Drawn, measure as measure
from .remedy_search import Remedies as Remedies, Remedy as Remedy
from .rules import OUTCOMES as OUTCOMES, RULES as RULES, SHOWN as SHOWN, Outcome as Outcome, VerdictRule as VerdictRule
from .verdict import (
    Reason as Reason,
    Verdict as Verdict,
    VerdictFigures as VerdictFigures,
)
from .words import (
    figure_rows as figure_rows,
    force_in_words as force_in_words,
    overload_lines as overload_lines,
    reason_lines as reason_lines,
    remedy_in_words as remedy_in_words,
    rule_rows as rule_rows,
    value_in_words as value_in_words,
    worse_lines as worse_lines,
)
