"""A page about a recorded run: reading its bags, what happened in it, the plots, and the page itself."""
import os

os.environ['MPLBACKEND'] = 'svg'  # whatever the user's matplotlib shows windows with
