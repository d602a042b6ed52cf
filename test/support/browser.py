"""A page as a real browser (Chromium's engine, by Qt WebEngine) shows it: what its console says, what it asks the network for,
and a picture. Prints it as JSON.
"""
import argparse
import json
import os
import sys

os.environ.setdefault('QT_QPA_PLATFORM', 'offscreen')
os.environ.setdefault('QT_QUICK_BACKEND', 'software')  # needs no OpenGL
os.environ.setdefault('QTWEBENGINE_DISABLE_SANDBOX', '1')  # its sandbox does not run as root, as in a container
FLAGS = '--disable-gpu --disable-dev-shm-usage'

PROBE = '''JSON.stringify({
  figures: Object.fromEntries([...document.querySelectorAll('[data-figure]')].map(e => [e.dataset.figure, +e.dataset.value])),
  sections: [...document.querySelectorAll('section')].map(e => e.id),
  plots: [...document.querySelectorAll('.plot svg')].map(e => ({name: e.classList[0], width: e.getBoundingClientRect().width,
    height: e.getBoundingClientRect().height, words: e.textContent.replace(/\\s+/g, ' ')})),
  images: [...document.querySelectorAll('svg image')].map(e => getComputedStyle(e.closest('[id*=cells]') || e).display),
  height: document.documentElement.scrollHeight, overflow: document.documentElement.scrollWidth - window.innerWidth,
  ids: [...document.querySelectorAll('[id]')].map(e => e.id), text: document.body.innerText,
  background: getComputedStyle(document.body).backgroundColor})'''


class Shown:
    """What the browser made of the page."""

    def __init__(self):
        self.loaded, self.console, self.requests, self.found = False, [], [], {}


def show(path, picture=None, width=1100, dark=False):
    """Loads the page and returns a Shown; saves a picture of all of it where one is asked for. Once in a process."""
    os.environ['QTWEBENGINE_CHROMIUM_FLAGS'] = FLAGS + (' --blink-settings=preferredColorScheme=%d' % (0 if dark else 1))
    from PyQt5.QtCore import QTimer, QUrl
    from PyQt5.QtWebEngineCore import QWebEngineUrlRequestInterceptor
    from PyQt5.QtWebEngineWidgets import QWebEnginePage, QWebEngineView
    from PyQt5.QtWidgets import QApplication
    shown = Shown()
    page_url = QUrl.fromLocalFile(os.path.abspath(path))

    class Page(QWebEnginePage):
        def javaScriptConsoleMessage(self, level, message, line, source):
            shown.console.append('%s (line %d)' % (message, line))

    class Interceptor(QWebEngineUrlRequestInterceptor):
        def interceptRequest(self, request):
            if request.requestUrl() != page_url and request.requestUrl().scheme() != 'data':
                shown.requests.append(request.requestUrl().toString())
                request.block(True)

    application = QApplication(['browser'])
    view, interceptor = QWebEngineView(), Interceptor()
    page = Page(view)
    page.profile().setUrlRequestInterceptor(interceptor)
    view.setPage(page)
    view.resize(width, 800)
    view.show()

    def take_picture():
        if picture:
            view.grab().save(picture)
        application.quit()

    def take(text):
        shown.found.update(json.loads(text))
        view.resize(width, min(16000, shown.found['height']) if picture else 800)
        QTimer.singleShot(5000 if picture else 0, take_picture)

    def look(loaded):
        shown.loaded = loaded
        QTimer.singleShot(300, lambda: page.runJavaScript(PROBE, take))

    page.loadFinished.connect(look)
    QTimer.singleShot(200000, application.quit)
    page.load(page_url)
    application.exec_()
    return shown


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('page')
    parser.add_argument('--picture')
    parser.add_argument('--width', type=int, default=1100)
    parser.add_argument('--dark', action='store_true')
    arguments = parser.parse_args()
    shown = show(arguments.page, arguments.picture, arguments.width, arguments.dark)
    print(json.dumps({'loaded': shown.loaded, 'console': shown.console, 'requests': shown.requests, **shown.found}), flush=True)
    os._exit(0)  # without the browser's long goodbye


if __name__ == '__main__':
    main()
