# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules for pairs of parts that move at the same time (neighbour_rules.Rule). They replace the
common required distance. A document stores three lists: the two parts of each rule one after the
other, the kinds, the lengths (mm). The rule of a group applies to all parts in it."""
from .. import convert
from ..convert import InputProblem
from ..texts import translate
from . import containers, neighbour_rules
from .neighbour_rules import Rule


def key(one, other):
    """Returns the key of two parts, each (root, sub); it does not depend on their order."""
    a, b = (one[0].Name, one[1]), (other[0].Name, other[1])
    return (one, other) if a <= b else (other, one)


def label_of(pair):
    """Returns the text for a pair of parts."""
    return " - ".join(convert.label_of(*part) for part in pair)


def read(obj):
    """Returns the rules of an object as {key: Rule}. Raises InputProblem if the lengths of its
    lists do not match."""
    parts = convert.pairs_of(obj.RuleParts)
    if not len(parts) == 2 * len(obj.RuleKinds) == 2 * len(obj.RuleLengths):
        raise InputProblem(
            translate(
                "SweptVolume",
                'The rules of "{0}" are incomplete: each rule needs two parts, a kind and a '
                "length, but there are {1} parts, {2} kinds and {3} lengths. Enter the rules again.",
            ).format(obj.Label, len(parts), len(obj.RuleKinds), len(obj.RuleLengths))
        )
    pairs = [key(*two) for two in zip(parts[::2], parts[1::2])]
    return neighbour_rules.checked(obj, zip(pairs, map(label_of, pairs)))


def write(obj, rules):
    """Writes rules into an object if they differ from its rules."""
    given = []
    for (one, other), rule in rules.items():
        if rule.asks():
            firsts, seconds = (containers.links_for(obj, [part]) for part in (one, other))
            given += [((a, b), rule) for a in firsts for b in seconds]
    neighbour_rules.set_lists(
        obj, [link for pair, _ in given for link in pair], [r for _, r in given]
    )


def of(rules, one, other):
    """Returns the rule of two parts: their own rule, or that of the smallest groups around them.
    Raises InputProblem if two rules contradict each other and neither is more specific: one has
    the smaller group around the first part, the other around the second."""
    # The rules that apply: (lengths of the paths to both groups, rule, pair).
    applying = []
    for pair, rule in rules.items():
        for a, b in (pair, pair[::-1]):
            holds = all(
                root is above and path.startswith(sub)
                for (above, sub), (root, path) in ((a, one), (b, other))
            )
            if holds:
                applying.append(((len(a[1]), len(b[1])), rule, pair))
    narrowest = [
        row for row in applying if not any(_narrower(other[0], row[0]) for other in applying)
    ]
    for _, rule, pair in narrowest[1:]:
        if rule != narrowest[0][1]:
            raise _contradiction((one, other), narrowest[0][2], pair)
    return narrowest[0][1] if narrowest else Rule()


def _narrower(one, other):
    """Returns whether the first rule is more specific: neither of its groups is larger than in the
    other rule, and one is smaller."""
    return one != other and all(a >= b for a, b in zip(one, other))


def _contradiction(parts, first, second):
    text = translate(
        "SweptVolume",
        'The rules for "{0}" and for "{1}" contradict each other for the pair "{2}", and '
        "neither takes precedence: add a rule for exactly this pair.",
    )
    return InputProblem(text.format(label_of(first), label_of(second), label_of(parts)))


def merged(rules, shown, given):
    """Does the same as neighbour_rules.merged(), for pairs."""
    return neighbour_rules.merged(rules, shown, given, of)


def drop(obj, gone):
    """Removes the rules that name an object that is being deleted; its links disappear, too."""
    links = convert.links_in(obj.RuleParts)
    if not len(links) == 2 * len(obj.RuleKinds) == 2 * len(obj.RuleLengths):
        return
    count = len(obj.RuleKinds)
    kept = [k for k in range(count) if gone not in (links[2 * k][0], links[2 * k + 1][0])]
    if len(kept) < count:
        rules = [Rule(obj.RuleKinds[k], obj.RuleLengths[k]) for k in kept]
        neighbour_rules.set_lists(obj, [links[i] for k in kept for i in (2 * k, 2 * k + 1)], rules)


def words(rules):
    """Returns the text of the rules for the hash of inputs: independent of their order, "" if there
    are no rules."""
    texts = [
        "|".join([root.Name + "." + sub for root, sub in pair] + [rule.text()])
        for pair, rule in rules.items()
        if rule.asks()
    ]
    return "\n".join(sorted(texts))
