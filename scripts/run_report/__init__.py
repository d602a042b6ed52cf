"""A page about a recorded run: reading its bags, what happened in it, the plots, and the page itself."""
import os

os.environ.pop('SOURCE_DATE_EPOCH', None)  # matplotlib reads it, and the pages show no date of their drawings
os.environ['MPLBACKEND'] = 'svg'  # whatever the user's matplotlib shows windows with
