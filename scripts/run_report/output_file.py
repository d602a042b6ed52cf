"""Where the page goes: all or nothing, and never over one of the bags, through a link, or unasked over the page of somebody else."""
import os
import tempfile

from command_line import end_undisturbed

from .bag_files import ReportError

MARK = '<meta name="generator" content="frontier_pilot report">'  # near the beginning of each page
MARK_OF_EARLIER_VERSIONS = '<link rel="icon" href="data:,">\n<title>Report of a run</title>\n'


def check(out, bags):
    """Raises ReportError if the page must not be written to `out`."""
    if not os.path.exists(out):
        return
    if not os.path.isfile(out):
        raise ReportError('%s is no file: name another one with --out' % out)
    if any(os.path.samefile(out, bag) for bag in bags):
        raise ReportError('%s is one of the bags that are read: name another file with --out' % out)


def check_unasked(out):
    """Raises ReportError if `out`, which the user has not named, is there and is no page that this program has made."""
    if os.path.lexists(out) and not is_page(out):
        raise ReportError('%s is there already, and is no page of this program: name another file, or this one to replace it, '
                          'with --out' % out)


def is_page(path):
    """Whether this program has made the file."""
    if not os.path.isfile(path):
        return False
    with open(path, 'rb') as file:
        beginning = file.read(1000)
    return any(mark.encode() in beginning for mark in (MARK, MARK_OF_EARLIER_VERSIONS))


def write(out, text):
    """Puts the page into the place of `out`; of a link, not of the file that it points to. Raises ReportError if it cannot."""
    try:
        _replace(out, text)
    except OSError as error:
        raise ReportError('%s cannot be written: %s' % (out, error.strerror)) from error


def _replace(out, text):
    descriptor, part = tempfile.mkstemp(prefix='.report', suffix='.part', dir=os.path.dirname(os.path.abspath(out)))
    try:
        with open(descriptor, 'w', encoding='utf-8', errors='replace') as file:  # a path may be no text
            file.write(text)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(part, 0o666 & ~mask)
        end_undisturbed()  # once the page is there, it is not said that there is none
        os.replace(part, out)
    except BaseException:
        os.remove(part)
        raise
