# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules of neighbours: what single parts, or groups of them, ask for instead of the common distance. One
concept for checks and for searches; the core has the same (docs/clearance.md, "Rules").

In a document the rules are three lists of one length: the parts, the kinds, the lengths (mm)."""
import math

from .. import convert
from ..convert import InputProblem
from ..texts import translate
from . import containers

REQUIRED, CONTACT, IGNORE = KINDS = ("Required", "Contact", "Ignore")
PARTS_PROPERTY = "RuleParts"


class Rule:
    """kind: of KINDS; length (mm): the distance asked for, or how deep a contact may be; None: the common
    distance, or a contact that cannot be told from touching."""

    def __init__(self, kind=REQUIRED, length=None):
        self.kind, self.length = kind, length

    def __eq__(self, other):
        return self.text() == other.text()

    def asks(self):
        """Whether it says anything."""
        return self.kind != REQUIRED or self.length is not None

    def text(self):
        """As the core takes it; None where the common distance holds."""
        if self.kind == IGNORE:
            return "ignore"
        if self.kind == CONTACT:
            return "contact:{!r}".format(float(self.length)) if self.length else "contact"
        return None if self.length is None else repr(float(self.length))


def from_text(text):
    """The rule that a text of the core stands for."""
    if text == "ignore":
        return Rule(IGNORE)
    if text.startswith("contact"):
        return Rule(CONTACT, float(text.partition(":")[2] or 0.0) or None)
    return Rule(REQUIRED, float(text)) if text else Rule()


def check(rule, label):
    """Raises InputProblem where a rule is impossible. label: whose."""
    if rule.kind not in KINDS:
        raise InputProblem(
            translate(
                "Messages", '"{0}" has the unknown rule "{1}": use Required, Contact or Ignore.'
            ).format(label, rule.kind)
        )
    if rule.length is not None and not (math.isfinite(rule.length) and rule.length >= 0):
        raise InputProblem(
            translate(
                "Messages", 'The distance in the rule of "{0}" is {1} mm: enter 0 or more.'
            ).format(label, "{:g}".format(rule.length))
        )


def read(obj):
    """{(root, sub): Rule} of an object of ours. Raises InputProblem where its lists do not fit each other."""
    pairs = convert.pairs_of(obj.RuleParts)
    if not len(pairs) == len(obj.RuleKinds) == len(obj.RuleLengths):
        raise InputProblem(
            translate(
                "Messages",
                'The rules of "{0}" are inconsistent: there are {1} parts, {2} kinds '
                "and {3} lengths, but these numbers must be equal. Enter the rules "
                "again.",
            ).format(obj.Label, len(pairs), len(obj.RuleKinds), len(obj.RuleLengths))
        )
    return checked(obj, zip(pairs, (convert.label_of(*pair) for pair in pairs)))


def checked(obj, parts):
    """{key: Rule} of the kinds and lengths of an object of ours; parts: (key, label) of each. Raises
    InputProblem."""
    rules = {}
    for (part, label), kind, length in zip(parts, obj.RuleKinds, obj.RuleLengths):
        rule = Rule(kind, length)
        check(rule, label)
        if kind == CONTACT and not rule.length:
            rule.length = None
        if part in rules and rules[part] != rule:
            text = translate(
                "Messages", 'Two rules for "{0}" contradict each other: remove one of them.'
            )
            raise InputProblem(text.format(label))
        rules[part] = rule
    return rules


def write(obj, rules):
    """Puts rules into an object of ours, if they are others than now."""
    links, given = [], []
    for pair, rule in rules.items():
        for link in containers.links_for(obj, [pair]) if rule.asks() else []:
            links.append(link)
            given.append(rule)
    set_lists(obj, links, given)


def set_lists(obj, links, rules):
    """Writes links, and what each rule says, if they are others than now."""
    kinds = [rule.kind for rule in rules]
    lengths = [float(rule.length or 0.0) for rule in rules]
    if convert.links_in(obj.RuleParts) != links:
        obj.RuleParts = links
    if list(obj.RuleKinds) != kinds:
        obj.RuleKinds = kinds
    if list(obj.RuleLengths) != lengths:
        obj.RuleLengths = lengths


def of(rules, root, path):
    """The rule of a part: its own, or that of the smallest group around it."""
    found, letters = Rule(), -1
    for (above, sub), rule in rules.items():
        if above is root and path.startswith(sub) and len(sub) > letters:
            found, letters = rule, len(sub)
    return found


def merged(rules, shown, given):
    """Rules after some neighbours were given others. shown: all of which a user saw the rules; given: {pair:
    Rule} of those of them that ask for something. Rules of what was not seen stay; a rule of a group
    stays while all that it is for follow it."""
    if all(of(rules, *pair) == given.get(pair, Rule()) for pair in shown):
        return dict(rules)
    kept = {
        (above, sub): rule
        for (above, sub), rule in rules.items()
        if not any(root is above and path.startswith(sub) for root, path in shown)
    }
    return {**kept, **given}


def drop(obj, gone):
    """An object is being deleted, and its links with it: its rules go too."""
    links = convert.links_in(obj.RuleParts)
    if not len(links) == len(obj.RuleKinds) == len(obj.RuleLengths):
        return
    kept = [k for k, (root, _) in enumerate(links) if root is not gone]
    if len(kept) < len(links):
        obj.RuleKinds = [obj.RuleKinds[k] for k in kept]
        obj.RuleLengths = [obj.RuleLengths[k] for k in kept]


def words(rules):
    """What stands for rules in the hash of inputs: the same in any order; "" where there are none."""
    return "\n".join(
        sorted(
            "{}|{}|{}".format(r.Name, sub, rule.text())
            for (r, sub), rule in rules.items()
            if rule.asks()
        )
    )
