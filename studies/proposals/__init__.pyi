from .design_writing import new_design as new_design, new_path as new_path, write_proposal as write_proposal
from .designer_question import PLACES as PLACES, Place as Place, Question as Question, question as question
from .other_questions import Alternative as Alternative, alternatives as alternatives
from .proposing import (
    Proposal as Proposal,
    Proposals as Proposals,
    propose as propose,
    propose_designs as propose_designs,
)
