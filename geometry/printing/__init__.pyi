from .plates import export_plates as export_plates
from .printability import PrintReport as PrintReport
from .report_files import report_content as report_content, write_report as write_report
