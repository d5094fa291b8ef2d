from .jobs import JOBS as JOBS
from .leak_testing import LeakTest as LeakTest, leak_tests as leak_tests
from .making import MadeParts as MadeParts, export_parts as export_parts
from .ordering import OrderLine as OrderLine, OrderList as OrderList, Spares as Spares
from .work_hours import Work as Work
