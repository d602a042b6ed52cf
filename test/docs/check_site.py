#!/usr/bin/python3
"""Builds the documentation's site, and names every link in it, and in the other pages of the repository, that leads nowhere.

MkDocs itself checks the files that pages link to; here the anchors within them are checked too, pictures and scripts, and that no
page needs the network: only links that a reader follows may lead out. A page that no other one links to is named as well.

Usage: check_site.py SITE_DIRECTORY    (written anew)
"""
import glob
import html.parser
import os
import subprocess
import sys
import urllib.parse

import markdown

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


class Page(html.parser.HTMLParser):
    """The anchors of a page, what it links to, and what a browser loads for it."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links, self.loaded = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.anchors.update(found[key] for key in ('id', 'name') if found.get(key))
        if tag == 'a' and found.get('href'):
            self.links.append(found['href'])
        if tag == 'link' and found.get('rel') in ('stylesheet', 'shortcut icon', 'icon'):
            self.loaded.append(found['href'])
        if found.get('src'):
            self.loaded.append(found['src'])


def read(path):
    """A page, from HTML or from Markdown, with the anchors that the site gives its headings."""
    with open(path, encoding='utf-8') as file:
        text = file.read()
    return Page(markdown.markdown(text, extensions=['toc', 'tables', 'fenced_code']) if path.endswith('.md') else text)


def problems_of(path, pages, linked):
    """What is wrong with the links of a page; adds the files that they lead to to `linked`."""
    page = pages.setdefault(path, read(path))
    for target in page.links + page.loaded:
        parts = urllib.parse.urlsplit(target)
        if parts.scheme or parts.netloc:
            if target in page.loaded:
                yield f'{path} loads {target} from the network'
            continue
        file = os.path.normpath(os.path.join(os.path.dirname(path), urllib.parse.unquote(parts.path))) if parts.path else path
        if not os.path.exists(file):
            yield f'{path} links to {target}, which is not there'
            continue
        linked.add(file)
        if parts.fragment and file.endswith(('.html', '.md')):
            if parts.fragment not in pages.setdefault(file, read(file)).anchors:
                yield f'{path} links to {target}: there is no such heading'


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith('-'):
        sys.exit(__doc__)
    site = os.path.abspath(sys.argv[1])
    subprocess.run(['mkdocs', 'build', '--quiet', '--config-file', os.path.join(ROOT, 'mkdocs.yml'), '--site-dir', site],
                   check=True)
    paths = sorted(glob.glob(site + '/**/*.html', recursive=True))
    paths = [path for path in paths if os.path.basename(path) != '404.html']  # its links are those of the site's root
    paths += [path for path in glob.glob(ROOT + '/**/*.md', recursive=True) if not path.startswith(ROOT + '/build')]
    pages, linked = {}, set()
    problems = {problem for path in paths for problem in problems_of(path, pages, linked)}
    problems |= {f'no page links to {path}' for path in paths if path.startswith(site) and path not in linked}
    for problem in sorted(problems):
        print(problem.replace(ROOT + '/', ''))
    print(f'{len(paths)} pages, {len(problems)} problems')
    sys.exit(1 if problems else 0)


if __name__ == '__main__':
    main()
