"""A page about a recorded run: reading its bags, what happened in it, the plots, and the page itself."""
