# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules of neighbours: for single parts or groups they replace the common required distance. Checks
and searches use the same rules, as does the core (docs/clearance.md, "Rules").

A document stores the rules as three lists of equal length: the parts, the kinds, the lengths (mm).
"""
import math

from .. import convert
from ..convert import InputProblem
from ..texts import translate
from . import containers

REQUIRED, CONTACT, IGNORE = KINDS = ("Required", "Contact", "Ignore")
PARTS_PROPERTY = "RuleParts"


class Rule:
    """kind: one of KINDS. length (mm): the required distance, or the largest depth of a contact.
    None: the common distance, or a contact without measurable overlap."""

    def __init__(self, kind=REQUIRED, length=None):
        self.kind, self.length = kind, length

    def __eq__(self, other):
        return self.text() == other.text()

    def asks(self):
        """Returns whether the rule differs from the default."""
        return self.kind != REQUIRED or self.length is not None

    def text(self):
        """Returns the rule as the text that the core takes, or None for the common distance."""
        if self.kind == IGNORE:
            return "ignore"
        if self.kind == CONTACT:
            return "contact:{!r}".format(float(self.length)) if self.length else "contact"
        return None if self.length is None else repr(float(self.length))


def from_text(text):
    """Returns the rule for a text of the core."""
    if text == "ignore":
        return Rule(IGNORE)
    if text.startswith("contact"):
        return Rule(CONTACT, float(text.partition(":")[2] or 0.0) or None)
    return Rule(REQUIRED, float(text)) if text else Rule()


def check(rule, label):
    """Raises InputProblem if a rule is impossible. label: the part that has the rule."""
    if rule.kind not in KINDS:
        raise InputProblem(
            translate(
                "SweptVolume", '"{0}" has the unknown rule "{1}": use Required, Contact or Ignore.'
            ).format(label, rule.kind)
        )
    if rule.length is not None and not (math.isfinite(rule.length) and rule.length >= 0):
        raise InputProblem(
            translate(
                "SweptVolume", 'The distance in the rule of "{0}" is {1} mm: enter 0 or more.'
            ).format(label, "{:g}".format(rule.length))
        )


def read(obj):
    """Returns the rules of an object as {(root, sub): Rule}. Raises InputProblem if the lengths of
    its lists differ."""
    pairs = convert.pairs_of(obj.RuleParts)
    if not len(pairs) == len(obj.RuleKinds) == len(obj.RuleLengths):
        raise InputProblem(
            translate(
                "SweptVolume",
                'The rules of "{0}" are incomplete: each rule needs a part, a kind and a '
                "length, but there are {1} parts, {2} kinds and {3} lengths. Enter the rules again.",
            ).format(obj.Label, len(pairs), len(obj.RuleKinds), len(obj.RuleLengths))
        )
    return checked(obj, zip(pairs, (convert.label_of(*pair) for pair in pairs)))


def checked(obj, parts):
    """Returns {key: Rule} from the kinds and lengths in an object's properties. parts: (key, label)
    of each rule. Raises InputProblem."""
    rules = {}
    for (part, label), kind, length in zip(parts, obj.RuleKinds, obj.RuleLengths):
        rule = Rule(kind, length)
        check(rule, label)
        if kind == CONTACT and not rule.length:
            rule.length = None
        if part in rules and rules[part] != rule:
            text = translate(
                "SweptVolume", 'There are two different rules for "{0}": remove one of them.'
            )
            raise InputProblem(text.format(label))
        rules[part] = rule
    return rules


def write(obj, rules):
    """Writes rules into an object if they differ from its rules."""
    links, given = [], []
    for pair, rule in rules.items():
        for link in containers.links_for(obj, [pair]) if rule.asks() else []:
            links.append(link)
            given.append(rule)
    set_lists(obj, links, given)


def set_lists(obj, links, rules):
    """Writes links, kinds and lengths of rules if they differ from the stored ones."""
    kinds = [rule.kind for rule in rules]
    lengths = [float(rule.length or 0.0) for rule in rules]
    if convert.links_in(obj.RuleParts) != links:
        obj.RuleParts = links
    if list(obj.RuleKinds) != kinds:
        obj.RuleKinds = kinds
    if list(obj.RuleLengths) != lengths:
        obj.RuleLengths = lengths


def of(rules, root, path):
    """Returns the rule of a part: its own rule, or that of the smallest group around it."""
    found, letters = Rule(), -1
    for (above, sub), rule in rules.items():
        if above is root and path.startswith(sub) and len(sub) > letters:
            found, letters = rule, len(sub)
    return found


def merged(rules, shown, given, of=of):
    """Returns the rules after the user changed some. shown: all neighbours whose rules the user
    saw. given: {pair: Rule} of those that now have a rule. A neighbour whose rule was changed gets
    a rule of its own, and rules of groups stay. No rule can say that the default holds again. So if
    a neighbour in a group was set back to the default, the group loses its rule, and its other
    neighbours that are shown get this rule instead."""
    wanted = {pair: given.get(pair, Rule()) for pair in shown}
    freed = [p for p in shown if not wanted[p].asks() and of(rules, *p).asks()]
    found = {
        key: rule
        for key, rule in rules.items()
        if not any(of({key: rule}, *pair).asks() for pair in freed)
    }
    own = {pair: rule for pair, rule in wanted.items() if of(found, *pair) != rule}
    return {**found, **own}


def drop(obj, gone):
    """Removes the rules that name an object that is being deleted; its links disappear, too."""
    links = convert.links_in(obj.RuleParts)
    if not len(links) == len(obj.RuleKinds) == len(obj.RuleLengths):
        return
    kept = [k for k, (root, _) in enumerate(links) if root is not gone]
    if len(kept) < len(links):
        obj.RuleKinds = [obj.RuleKinds[k] for k in kept]
        obj.RuleLengths = [obj.RuleLengths[k] for k in kept]


def words(rules):
    """Returns the text of the rules for the hash of inputs: independent of their order, "" if there
    are no rules."""
    return "\n".join(
        sorted(
            "{}|{}|{}".format(r.Name, sub, rule.text())
            for (r, sub), rule in rules.items()
            if rule.asks()
        )
    )
