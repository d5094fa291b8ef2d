"""Random designs whose parts lie close together, of every kind of layout."""

from hypothesis import strategies as st

import geometry


def number(low, high):
    """A length to a hundredth: a draw often meets another exactly, as the lengths of people do."""
    return st.integers(round(100 * low), round(100 * high)).map(lambda count: count / 100)


@st.composite
def tubes(draw, shortest):
    bore = draw(number(0.2, 0.8))
    wire, wall = draw(number(0.03, 0.15)), draw(number(0.05, 0.4))
    tube = {"length": shortest + 4 * bore + draw(st.one_of(number(0.05, 3), number(3, 25))), "inner_diameter": bore}
    tube |= {"wire_diameter": wire, "outer_diameter": round(bore + 2 * wire + 2 * wall, 3)}
    if draw(st.booleans()):
        tube["bend_radius"] = draw(number(0.3, 4))
    return tube


@st.composite
def designs(draw):
    """Designs of two to seven points whose parts lie close together, of every kind of layout."""
    wall, chamber_wall = draw(number(0.5, 2.5)), draw(number(0.4, 2.5))
    tube = draw(tubes(2 * wall))
    outer = tube["outer_diameter"] if draw(st.booleans()) else None
    microphone_tube = {**(tube if outer else draw(tubes(0.0))), "length": wall + chamber_wall + draw(number(1.5, 12))}
    widest = max(tube["outer_diameter"], microphone_tube["outer_diameter"])
    gap = draw(number(0.02, 0.1))
    cavity = round(2 * widest + draw(number(0.2, 5)), 3)
    height = round(widest + 2 * gap + 0.25 + draw(number(0, 2)), 3)
    rim = round(wall * draw(st.sampled_from([0.5, 0.75, 1.0])), 3)
    kind = draw(st.sampled_from(["serpentine", "serpentine", "ring", "cylinder", "hand"]))
    count = draw(st.integers(2, 6))
    layout = {"kind": kind, "columns": draw(st.integers(1, 4))}
    names, lines = ["A", "B"], [{"between": ["A", "B"], "points": count}]
    if kind == "serpentine" and draw(st.booleans()):
        names = ["A", "B", "C"]
        lines = [{"between": ["A", "B"], "points": count}, {"between": ["B", "C"], "points": draw(st.integers(1, 3))}]
    if kind == "ring":
        names = ["A", "B", "C"]
        lines = [{"between": [names[k], names[(k + 1) % 3]], "points": draw(st.integers(1, 3))} for k in range(3)]
    if kind == "hand":
        layout |= {"palm": draw(number(15, 60)), "spread": draw(number(8, 40)), "columns": draw(st.integers(1, 3))}
        if draw(st.booleans()):
            names, lines = ["A", "B", "C"], [{"between": ["A", "B"], "points": 2}, {"between": ["B", "C"], "points": 3}]
    if kind == "cylinder":
        layout["diameter"] = draw(number(6, 60))
    elif draw(st.booleans()):
        share = draw(st.sampled_from([0.0, 0.02, 0.3, 0.6, 0.9, 0.98]))
        shells, straight = cavity + 2 * wall, cavity + tube["length"]
        layout["pitch"] = round(shells + share * (straight - shells), 3)
    shell = {}
    if draw(st.integers(0, 2)) == 0:
        shell = {"feet": draw(st.integers(1, 4)), "foot_hole": 0.5, "foot_length": draw(number(1.8, 3.5))}
    microphone = {"chamber_diameter": round(2 * widest + draw(number(0.1, 2)), 3), "wall_thickness": chamber_wall}
    microphone |= {"chamber_height": round(widest + 2 * gap + 0.2 + draw(number(0, 1)), 3)}
    microphone |= {"package_length": draw(number(1, 5)), "package_width": draw(number(1, 4))}
    floor = draw(number(0.3, 1.5))
    given = {
        "microphones": names,
        "lines": lines,
        "layout": layout,
        "shell": shell,
        "tube": tube,
        "microphone_tube": microphone_tube,
        "resonator": {
            "cavity_diameter": cavity,
            "cavity_height": height,
            "wall_thickness": wall,
            "floor_thickness": floor,
            "shape": draw(st.sampled_from(["cylinder", "cylinder", "box", "dome"])),
        },
        "membrane.rim_width": rim,
        "membrane.stretch": draw(st.sampled_from([1.0, 1.3])),
        "printing.glue_gap": gap,
        "printing.port_lip": draw(number(0.2, 0.4)),
        **{f"microphone.{name}": value for name, value in microphone.items()},
    }
    try:
        return geometry.prototype("array-2x6").with_values(given)
    except geometry.DesignError:
        return None
