"""Names of files and folders that are taken as soon as they are found to be free."""


def take(path, make):
    """Calls `make` with `path`, then with a number behind it for as long as `make` raises FileExistsError, and returns the path for
    which it did not. Throws OSError."""
    for copy in range(100):
        free = path + ('_%d' % copy if copy else '')
        try:
            make(free)
        except FileExistsError:
            continue
        return free
    raise FileExistsError('%s and a hundred more of this name exist already' % path)
