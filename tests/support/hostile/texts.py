"""TOML that is no TOML, or says what it must not."""

from __future__ import annotations

#: In the place of the whole text.
TEXTS = (
    ("nested a thousand deep", "a = " + "[" * 1000 + "]" * 1000),
    ("tables a thousand deep", "[" + ".".join("a" * 1000) + "]\n"),
    ("a number of 5,000 digits", "a = " + "9" * 5000),
    ("no end of a text", 'name = "abc'),
    ("a key twice", "name = 1\nname = 2\n"),
    ("no UTF-8", b'name = "\xff\xfe"'),
    ("a NUL", b'name = "a\x00b"'),
    ("an unknown key", "nonsense = 1\n"),
    ("a date for all", "name = 1979-05-27T07:32:00Z\n"),
)
#: Before the text.
ADDED = (
    ("an unknown key", "nonsense = 1\n"),
    ("nesting", "nonsense = " + "[" * 2000 + "]" * 2000 + "\n"),
    ("a huge number", "nonsense = " + "1" * 6000 + "\n"),
)
STUDY_CHANGES = (
    *(
        ('base = "design.toml"', f"base = {value}")
        for value in ('"nowhere.toml"', "[]", "1", '"/dev/zero"', '""', "{}")
    ),
    *(('fidelity = "lumped"', f"fidelity = {value}") for value in ('"none"', "1", "[]", "nan")),
    *(
        ('frequency = "1:100:8"', f"frequency = {value}")
        for value in (
            '"1:100:1000000000"',
            '"nan:1:2"',
            '"100:1:5"',
            '"-1:5:3"',
            "[]",
            "[5, 4]",
            "1",
            '"1:1e9:4"',
            '"a"',
        )
    ),
    *(
        ('metrics = ["distance_smallest", "sensitivity_force"]', f"metrics = {value}")
        for value in ("[]", '["none"]', "[1]", '"all"', "{}")
    ),
    *(("cases = 12", f"cases = {value}") for value in ("0", "-1", "1000000000000", "nan", '"a"', "1.5", "[]")),
    *(("seed = 1", f"seed = {value}") for value in ("-1", "1.5", '"a"', "99999999999999999999999999")),
    *(
        ("{ from = 0.3, to = 0.8 }", value)
        for value in (
            "{ from = 0.8, to = 0.3 }",
            "{ from = nan, to = 1 }",
            "{ from = 0.3 }",
            "[]",
            "{}",
            '["a"]',
            "true",
            "{ from = -5, to = -1 }",
            "{ from = 0.3, to = inf }",
            '{ from = 0.3, to = 0.8, scale = "cubic" }',
        )
    ),
    *(
        ('"tube.length" =', f"{value} =")
        for value in ('"tube.lenght"', '"name"', '"lines"', '"lines.9.points"', '"tube"')
    ),
    *(('sampling = "random"', f"sampling = {value}") for value in ('"none"', "1", "[]")),
)
MANIFEST_CHANGES = (
    *(('design = "design.toml"', f"design = {value}") for value in ('"nowhere"', "1", "[]", '"/dev/zero"')),
    *(("reference = 10.0", f"reference = {value}") for value in ("0", "-1", "nan", "inf", '"a"', "[]", "1e300")),
    *(("A = 2.0", f"{value}") for value in ("C = 2.0", "A = 0", "A = true", "A = {}")),
    *(("reference = 0.0123", f"reference = {value}") for value in ("59.0", "nan", '"late"', "-1e9", "inf")),
    *(
        ('1 = "point-1.wav"', value)
        for value in (
            '0 = "point-1.wav"',
            '7 = "point-1.wav"',
            '1 = "nowhere.wav"',
            "1 = 5",
            '1 = "/dev/zero"',
            "1 = []",
            '1 = "a\\u0000b"',
            'x = "point-1.wav"',
        )
    ),
)
PROCESS_CHANGES = (
    *(('base = "sla-resin"', f"base = {value}") for value in ("[]", "{}", "1", '"sls"', '"process.toml"')),
    *(("hole = 0.3", f"hole = {value}") for value in ("-1", "nan", "inf", '"a"', "[]", "1e300")),
    *(
        ("[120.0, 68.0, 150.0]", value)
        for value in ("[]", "[1, 2]", "[nan, 1, 1]", "[-1, 1, 1]", '"large"', "5", "[0, 0, 0]")
    ),
)
