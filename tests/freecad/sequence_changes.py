# SPDX-License-Identifier: LGPL-2.1-or-later
"""The changes of test_states_of_sequences.py: what a user can do to its document."""
from case import V, shift, turn
from table_case import add_box, changes, put_into

#: name -> what a user does.
CHANGES, change = changes()


@change
def more_clearance(doc):
    doc.Sequence.RequiredDistance = 0.7


@change
def as_much_clearance_as_there_is(doc):
    doc.Sequence.RequiredDistance = 0.89


@change
def another_order(doc):
    doc.Sequence.MovingParts = [(doc.Upper, ""), (doc.Lower, "")]
    doc.Sequence.Motions = list(reversed(doc.Sequence.Motions))


@change
def a_motion_too_few(doc):
    doc.Sequence.Motions = doc.Sequence.Motions[:1]


@change
def a_motion_is_edited(doc):
    path = doc.Sequence.Motions[1]
    path.Placements = [shift(30).multiply(path.Placements[0])] + path.Placements[1:]


@change
def a_motion_goes(doc):
    doc.removeObject(doc.Sequence.Motions[0].Name)


@change
def a_part_goes(doc):
    doc.removeObject("Upper")


@change
def a_wall_comes_nearer(doc):
    doc.West.Placement = shift(-12.8, -13)


@change
def a_wall_is_left_out(doc):
    doc.Sequence.Neighbours = [(doc.Floor, "")]


@change
def something_stands_above(doc):
    doc.Sequence.Neighbours = doc.Sequence.Neighbours + [
        (add_box(doc, "Above", shift(-5, -5, 50)), "")
    ]


@change
def all_that_is_visible(doc):
    doc.Sequence.AllVisible = True


@change
def a_pair_is_ignored(doc):
    doc.Sequence.RuleParts = [(doc.Upper, ""), (doc.Lower, "")]
    doc.Sequence.RuleKinds, doc.Sequence.RuleLengths = ["Ignore"], [0.0]


# --- parts


@change
def a_part_grows(doc):
    doc.Upper.Height = 10


@change
def a_part_has_no_room_any_more(doc):
    doc.Lower.Length = 19.9


@change
def a_part_stands_elsewhere(doc):
    doc.Upper.Placement = shift(-9, -9, 13)


@change
def a_part_is_a_link(doc):
    doc.Sequence.MovingParts = [(doc.Lower, ""), (doc.Link, "")]


@change
def the_part_behind_a_link_is_another(doc):
    a_part_is_a_link(doc)
    doc.recompute()
    doc.Link.LinkedObject = doc.Other


@change
def a_link_of_the_sequence_shows_nothing(doc):
    a_part_is_a_link(doc)
    doc.recompute()
    doc.Link.LinkedObject = None


@change
def a_part_is_in_a_group_that_stands_elsewhere(doc):
    put_into(doc.addObject("App::Part", "Group"), doc.Upper)


@change
def all_are_in_a_group(doc):
    group = doc.addObject("App::Part", "Group")
    for obj in [doc.Upper, doc.Lower] + [o for o, _ in doc.Sequence.Neighbours]:
        group.addObject(obj)


@change
def all_are_in_a_group_that_turns(doc):
    all_are_in_a_group(doc)
    doc.recompute()
    doc.Group.Placement = turn(20, base=V(0, 0, 5))


@change
def a_part_is_there_twice(doc):
    doc.Sequence.MovingParts = [(doc.Lower, ""), (doc.Lower, "")]


@change
def no_part(doc):
    doc.Sequence.MovingParts, doc.Sequence.Motions = [], []


@change
def a_part_is_hidden(doc):
    doc.Upper.Visibility = False


@change
def one_part_less(doc):
    doc.Sequence.MovingParts = [(doc.Lower, "")]
    doc.Sequence.Motions = doc.Sequence.Motions[:1]


# --- motions


@change
def a_motion_is_smooth(doc):
    doc.Sequence.Motions[1].Interpolation = "Spline"


@change
def a_motion_jumps(doc):
    doc.Sequence.Motions[1].Interpolation = "None"


@change
def a_motion_is_slower(doc):
    path = doc.Sequence.Motions[0]
    path.Times = [2 * t for t in path.Times]


@change
def a_motion_turns_about_another_point(doc):
    doc.Sequence.Motions[1].Pivot = V(0, 0, 5)


@change
def a_motion_counts_from_the_part(doc):
    doc.Sequence.Motions[1].PoseType = "Relative"


@change
def a_motion_is_a_copy(doc):
    doc.Sequence.Motions = [doc.copyObject(doc.Sequence.Motions[0]), doc.Sequence.Motions[1]]


@change
def both_have_one_motion(doc):
    doc.Sequence.Motions = 2 * doc.Sequence.Motions[:1]


@change
def the_last_key_is_elsewhere(doc):
    path = doc.Sequence.Motions[0]
    path.Placements = path.Placements[:-1] + [shift(0, 0, 2).multiply(path.Placements[-1])]


# --- what stands still


@change
def a_wall_grows(doc):
    doc.West.Length = 3.5


@change
def a_wall_goes(doc):
    doc.removeObject("North")


@change
def a_wall_is_a_link(doc):
    kept = [pair for pair in doc.Sequence.Neighbours if pair[0] is not doc.West]
    doc.Sequence.Neighbours = kept + [(doc.WallLink, "")]


@change
def a_wall_is_in_a_group_that_stands_elsewhere(doc):
    put_into(doc.addObject("App::Part", "Group"), doc.West, shift(0.2))


@change
def a_part_is_its_own_neighbour(doc):
    doc.Sequence.Neighbours = doc.Sequence.Neighbours + [(doc.Upper, "")]


@change
def the_envelope_is_in_the_way(doc):
    doc.Sequence.Neighbours = doc.Sequence.Neighbours + [(doc.Envelope, "")]


@change
def an_envelope_in_the_way_is_stale(doc):
    the_envelope_is_in_the_way(doc)
    doc.Other.Length = 4


@change
def a_wall_is_hidden(doc):
    doc.West.Visibility = False


@change
def what_stands_above_is_hidden_where_all_is_looked_at(doc):
    something_stands_above(doc)
    doc.Above.Visibility = False
    doc.Sequence.AllVisible = True


@change
def no_wall(doc):
    doc.Sequence.Neighbours = []


# --- settings, expressions, names


@change
def touching_at_the_end_is_allowed(doc):
    doc.Sequence.ReleaseDistance = 5


@change
def looked_at_more_closely(doc):
    doc.Sequence.Accuracy = 0.005


@change
def coarser_parts(doc):
    doc.Sequence.MeshDeflection = 0.1


@change
def clearance_by_an_expression(doc):
    doc.Sequence.setExpression("RequiredDistance", "Values.gap")


@change
def a_value_of_an_expression(doc):
    doc.Values.set("A1", "4 mm")  # the length of the part from which the envelope is made


@change
def a_rule_that_does_not_fit(doc):
    doc.Sequence.RuleKinds, doc.Sequence.RuleLengths = ["Ignore"], []


@change
def a_pair_asks_for_more(doc):
    doc.Sequence.RuleParts = [(doc.Upper, ""), (doc.West, "")]
    doc.Sequence.RuleKinds, doc.Sequence.RuleLengths = ["Required"], [3.0]


@change
def the_parts_exchange_their_names(doc):
    doc.Upper.Label, doc.Lower.Label = "Name", "Upper"
    doc.Upper.Label = "Lower"


@change
def a_part_has_another_name(doc):
    doc.Upper.Label = "Lid"


@change
def two_parts_have_one_name(doc):
    doc.Upper.Label = doc.Lower.Label = "Twin"


@change
def a_wall_has_another_name(doc):
    doc.West.Label = "Port"


@change
def a_motion_has_another_name(doc):
    doc.Sequence.Motions[0].Label = "Down"
