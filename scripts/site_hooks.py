"""Hook of MkDocs, see mkdocs.yml: the site takes KaTeX from Debian's package, so that it needs no network."""
import os

from mkdocs.structure.files import File

JAVASCRIPT = '/usr/share/javascript'


def on_files(files, config):
    """Adds KaTeX, and leaves out what is in docs/ for Doxygen: its commands mean nothing to MkDocs."""
    for file in list(files):
        if file.src_path == 'Doxyfile' or file.src_path.startswith('api/'):
            files.remove(file)
    for folder, _, names in os.walk(os.path.join(JAVASCRIPT, 'katex')):
        for name in names:
            path = os.path.relpath(os.path.join(folder, name), JAVASCRIPT)
            files.append(File(path, JAVASCRIPT, config['site_dir'], config['use_directory_urls']))
    return files
