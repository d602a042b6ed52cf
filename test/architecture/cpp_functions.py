"""Reads just enough C++ to find functions and their lengths: no preprocessor, no templates understood."""
import re

TOKEN = re.compile(r'''//[^\n]*|/\*.*?\*/|R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'|\n''', re.DOTALL)
SCOPE = re.compile(r'\b(namespace|class|struct|union|enum|extern)\b')
INITIALISER = re.compile(r'[\w>,(\]]$|= $')  # what stands before the brace of `x_{1}`, `f({1})`, `a = {1}`
CONTROL = re.compile(r'^\s*(if|for|while|switch|do|else|try|catch|return)\b')


def code_of(text, keep_strings=False):
    """The text without comments, and without what stands in strings unless they are kept; lines stay where they are."""
    def blank(match):
        token = match.group(0)
        if token.startswith('/') or not keep_strings:
            filler = '\n' * token.count('\n')
            return filler if token.startswith(('/', '\n')) else '""' + filler
        return token
    return TOKEN.sub(blank, text)


def functions_of(text):
    """(name, number of lines) of each function with a body, from the line of its name to that of its closing brace."""
    code = re.sub(r'^\s*#[^\n]*(\\\n[^\n]*)*', '', code_of(text), flags=re.MULTILINE)
    found, stack, head_start = [], [], 0
    for match in re.finditer(r'[{};]', code):
        token, at = match.group(0), match.start()
        if token == '{' and INITIALISER.search(code, max(0, at - 3), at):
            stack.append(('initialiser', '', at))
        elif token == '{':
            head = re.split(r'\b(?:public|private|protected)\s*:', code[head_start:at])[-1].lstrip()
            stack.append((kind_of(head, stack), head, at - len(head)))
            head_start = at + 1
        elif token == ';' or not stack:
            head_start = at + 1
        else:
            kind, head, start = stack.pop()
            if kind == 'function':
                found.append((name_of(head), code.count('\n', start, at) + 1))
            if kind != 'initialiser':
                head_start = at + 1
    return found


def kind_of(head, stack):
    if stack and stack[-1][0] in ('function', 'inside', 'initialiser'):
        return 'inside'
    if SCOPE.search(re.sub(r'<[^<>]*>', '', head).split('(')[0]) and not re.search(r'\)\s*(const|noexcept|override)*\s*$', head):
        return 'scope'
    return 'function' if '(' in head and not CONTROL.match(head) else 'inside'


def name_of(head):
    match = re.search(r'([\w:~]+|operator\S+)\s*\(', head)
    return match.group(1) if match else '?'
