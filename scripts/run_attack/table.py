"""The table of the faults in docs/reliability.md."""
import re

NOT_DRAWN = '–'
BEGIN, END = '<!-- the table of the faults begins -->', '<!-- the table of the faults ends -->'


def render(results, states, heading):
    """Markdown of {(node, fault, state): text}: a row for each fault of a node, a column for each state."""
    lines = [heading, '', '| node | fault | ' + ' | '.join(states) + ' |', '|---' * (len(states) + 2) + '|']
    for node, fault in sorted({(node, fault) for node, fault, _ in results}, key=lambda row: (row[0], _order(row[1]))):
        cells = [results.get((node, fault, state), NOT_DRAWN).replace('|', '/').replace('\n', ' ') for state in states]
        lines.append('| `%s` | %s | %s |' % (node, fault, ' | '.join(cells)))
    return '\n'.join(lines)


def _order(fault):
    """What ends a node first, then what it survives, by kind and length."""
    numbers = re.findall(r'\d+', fault)
    return (bool(numbers), fault.split()[0] != 'suspended', [int(number) for number in numbers], fault)


def replaced(page, table):
    """The page with the table between its marks replaced; ValueError for a page without the marks."""
    begin, end = page.find(BEGIN), page.find(END)
    if begin < 0 or end < begin:
        raise ValueError('the page does not say where the table belongs')
    return page[:begin + len(BEGIN)] + '\n\n' + table + '\n\n' + page[end:]
