from .reading import Body as Body, read_body as read_body
from .samples import Samples as Samples, samples_of as samples_of
