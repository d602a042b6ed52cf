"""The parameters of a run that differ from the defaults, by the tables of docs/parameters.md."""
import math
import os
import re

import yaml

ROW = re.compile(r'^\| `([^`]+)` \| ([^|]*) \| ([^|]*) \| ([^|]*) \| ([^|]*) \| (.*) \|$')


class Described:
    """A parameter as its table describes it."""

    def __init__(self, kind, default, unit, meaning):
        self.kind, self.default, self.unit, self.meaning = kind, default, unit, meaning


def read_tables(path):
    """The described parameters of each section: node, or group that many nodes have. Empty where there is no such file."""
    tables, section = {}, None
    if not os.path.exists(path):
        return tables
    with open(path, encoding='utf-8') as file:
        for line in file:
            if line.startswith('## '):
                section = tables.setdefault(line[3:].strip(), {})
            row = ROW.match(line.rstrip())
            if row and section is not None:
                name, kind, default, unit, _, meaning = (word.strip() for word in row.groups())
                section[name] = Described(kind, default, unit, meaning)
    return tables


def flat(values, prefix=''):
    """Nested dictionaries as one, with the keys joined by slashes; those in a list as `list[0]/key`."""
    out = {}
    for key, value in values.items():
        name = prefix + str(key)
        if isinstance(value, dict) and value:
            out.update(flat(value, name + '/'))
        elif isinstance(value, list) and value and all(isinstance(item, dict) for item in value):
            for index, item in enumerate(value):
                out.update(flat(item, '%s[%d]/' % (name, index)))
        else:
            out[name] = value
    return out


def same(value, default):
    """Whether a value is the default that is written as text."""
    try:
        parsed = yaml.safe_load(default) if default else ''
    except yaml.YAMLError:
        parsed = default
    if isinstance(value, list) and isinstance(parsed, list):
        return len(value) == len(parsed) and all(same(one, str(other)) for one, other in zip(value, parsed))
    if isinstance(value, bool) or isinstance(parsed, bool):
        return value is parsed
    try:
        return math.isclose(float(value), float(parsed), rel_tol=1e-4, abs_tol=1e-9)
    except (TypeError, ValueError, OverflowError):
        return str(value) == default.strip('"')


class Setting:
    """A parameter that differs from its default, or has changed during the run."""

    def __init__(self, nodes, name, value, described, changed_to):
        self.nodes, self.name, self.value = nodes, name, value
        self.default = described.default if described else None  # None: not known
        self.unit, self.meaning = (described.unit, described.meaning) if described else ('', '')
        self.changed_to = changed_to  # None: it has not


def differing(start, end, tables, namespace='/'):
    """The settings of a run, from the parameters at its start and at its end. What many nodes share stands once."""
    found = {}
    of_start, of_end = inside(start, namespace), inside(end, namespace)
    for node in dict.fromkeys([*of_start, *of_end]):
        if node not in tables:
            continue
        before, after = parameters_of(of_start, node), parameters_of(of_end, node)
        for name in dict.fromkeys([*before, *after]):
            described = describe(tables, node, name)
            if name not in before and not described:
                continue  # it is not known what held until somebody set it
            value = before[name] if name in before else value_until_set(before, name, described)
            changed = after[name] if name in after and not alike(after[name], value) else None
            if described and same(value, described.default) and changed is None:
                continue
            found.setdefault((name, str(value), str(changed)), Setting([], name, value, described, changed)).nodes.append(node)
    return sorted(found.values(), key=lambda setting: (-len(setting.nodes), setting.nodes, setting.name))


def parameters_of(nodes, node):
    return flat(nodes[node]) if isinstance(nodes.get(node), dict) else {}


def value_until_set(before, name, described):
    """What held for a parameter that was not on the parameter server at the start of the run: the robot's own limit, or the
    default."""
    robots = 'robot/' + name
    return before[robots] if robots in before else described.default.strip('"')


def alike(value, other):
    return value == other or same(value, str(other))


def inside(parameters, namespace):
    """The part of nested parameters in a namespace; empty where there is none."""
    for word in namespace.strip('/').split('/'):
        parameters = parameters.get(word, {}) if word and isinstance(parameters, dict) else parameters
    return parameters if isinstance(parameters, dict) else {}


def describe(tables, node, name):
    """The row of a parameter; that of the robot's own limits for limits that override them; None where there is none."""
    for section in (node, 'The robot', 'Frames'):
        row = tables.get(section, {}).get(name) or item_of_list(tables.get(section, {}), name)
        if row:
            return row
    return tables.get('The robot', {}).get('robot/' + name) if name.startswith('limits/') else None


def item_of_list(table, name):
    """The row of `list[i]/key`, in which the defaults of the items stand side by side where they differ."""
    match = re.match(r'(.*)\[([0-9]{1,9})\](/.*)$', name)
    row = table.get(match.group(1) + '[i]' + match.group(3)) if match else None
    if row is None:
        return None
    defaults, index = row.default.split(', '), int(match.group(2))
    default = defaults[0] if len(defaults) == 1 else defaults[index] if index < len(defaults) else ''
    return Described(row.kind, default, row.unit, row.meaning)
