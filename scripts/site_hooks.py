"""Hooks of MkDocs, see mkdocs.yml: the site begins with README.md, and takes KaTeX from Debian's package, so that it needs no network."""
import os
import re

from mkdocs.structure.files import File

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
JAVASCRIPT = '/usr/share/javascript'
FIRST = 'README.md'


def on_files(files, config):
    """Adds the first page and KaTeX, and leaves out what is in docs/ for Doxygen: its commands mean nothing to MkDocs."""
    for file in list(files):
        if file.src_path == 'Doxyfile' or file.src_path.startswith('api/'):
            files.remove(file)
    files.append(File(FIRST, ROOT, config['site_dir'], config['use_directory_urls']))
    for folder, _, names in os.walk(os.path.join(JAVASCRIPT, 'katex')):
        for name in names:
            path = os.path.relpath(os.path.join(folder, name), JAVASCRIPT)
            files.append(File(path, JAVASCRIPT, config['site_dir'], config['use_directory_urls']))
    return files


def on_page_markdown(markdown, page, **_):
    """Links of README.md begin in the repository: those into docs/ stay links, others lead out of the site and become text."""
    if page.file.src_path != FIRST:
        return markdown
    return re.sub(r'\[([^]]*)\]\(([^)]*)\)',
                  lambda link: f'[{link[1]}]({link[2][5:]})' if link[2].startswith('docs/') else link[1], markdown)
