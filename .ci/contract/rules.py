"""What the contract says in words rather than in JSON Schema, for schemathesis.

The document tells readers that exactly one way to the sinkage, one way to the slip, and either a preset or the fields
have to be given. Left to the schema alone nearly every generated request breaks one of these and never reaches the
model. So the rules are put into the schemas before requests are generated, and checks hold the service to the rest.
"""

import csv
import io
import json
import math
from copy import deepcopy
from itertools import product

import schemathesis

# Alternatives of which a request that has them all takes exactly one, whole. The load may also stand beside a sinkage.
SINKAGE = (
    ["sinkage_m"],
    ["static_sinkage_m"],
    ["normal_load_n"],
    ["sinkage_m", "normal_load_n"],
    ["static_sinkage_m", "normal_load_n"],
)
SLIP = (["slip"], ["forward_velocity_m_s", "angular_velocity_rad_s"])

# The same of one operating point, whose slip may be solved from its pull.
SOLVED_SLIP = (*SLIP, ["longitudinal_force_n"], ["drawbar_coefficient"])

# Those of which one at a time is generated.
ALONE = (["sinkage_m"], ["static_sinkage_m"], ["normal_load_n"], *SLIP)

# The same of a run over samples.
TRACKED_SINKAGE = (["static_sinkage_m"], ["normal_load_n"], ["static_sinkage_m", "normal_load_n"])

# Fields that have a meaning only beside another.
BESIDE = {"slip_sinkage": "static_sinkage_m"}

# What a track may ask for only beside columns that the samples below do not always have; tests of the service have it.
BESIDE_COLUMNS = ["strength"]

# What takes columns that their schema does not list; tests of the service have it.
BEYOND_THE_SCHEMA = ["extra_columns"]

# Soils of the catalogue whose contact was not measured.
PRESETS = ["letter-sand", "hit-lss1"]

# Fields that no variant has.
LEFT_OUT = [*BESIDE, *BESIDE_COLUMNS, *BEYOND_THE_SCHEMA, "variants", "bounds", "start", "standard_deviation", "estimator"]

# The method that takes no law of the soil.
GRAINS = "resistive_force"

# Fields of a wheel that moves at an angle to its plane.
SIDEWAYS = ["slip_angle_rad", "shear_coupling", "bulldozing"]

# Values that say the same as leaving the field out.
NEUTRAL = {"slip_angle_rad": [0], "rut": [False]}

# How the name of a schema ends as answers have it.
ANSWERED = "Answered"

# Columns of words.
WORDS = ["status", "stop_reason"]

# How a refusal starts whose reason stands in the schema: a bound, a type, a word, a name, a field that is left out.
IN_THE_SCHEMA = ("must be ", "must have ", "unknown name ", "unknown field", "is required")
# A field that may be required in spite of the schema: a value that nobody published for a preset.
NOT_PUBLISHED = "is required: the catalogue has no published value"
# And a field that may follow from others, which stand elsewhere: the weight of Reece's law from those of the soil.
FOLLOWS = "/pressure_sinkage/unit_weight_n_m3"


@schemathesis.hook
def before_load_schema(context, raw_schema):
    schemas = raw_schema["components"]["schemas"]
    answers_as_they_stand(raw_schema)
    whole_laws(schemas)
    for name, schema in schemas.items():
        if name.endswith(ANSWERED):
            continue
        slip = SOLVED_SLIP if has(schema, sum(SOLVED_SLIP, [])) else SLIP
        groups = [group for group in (SINKAGE, slip) if has(schema, sum(group, []))]
        if name == "TrackColumns":
            schema = samples(schema)
        if name == "CompareRequest":
            # Laws again, which are tried in the request itself; with them hardly a request is generated in a minute.
            # Tests of the service have them.
            schema = requiring(schema, [], without=["variants"])
        if name == "TrackRequest":
            groups = [TRACKED_SINKAGE]
            schema = requiring(schema, ["soil"], without=[*BESIDE_COLUMNS, *BEYOND_THE_SCHEMA])
        if name == "VehicleRequest":
            schemas[name] = one_of(rovers(schema))
        if groups:
            # A load beside a sinkage and a slip from its pull would make four times as many requests; tests of the service have them.
            alone = [[way for way in group if way in ALONE] for group in groups]
            variants = (chosen(schema, groups, choice) for choice in product(*alone))
            laid_apart = (variant for choice in variants for variant in by_soil(choice))
            zoned = (variant for choice in laid_apart for variant in by_zones(choice))
            schemas[name] = one_of(variant for of in zoned for variant in straight_or_sideways(of))
        if name == "TowedRequest":
            schemas[name] = one_of(by_soil(schema))
    wheel, soil, shear = schemas["Wheel"], schemas["Soil"], schemas["Shear"]
    schemas["Wheel"] = one_of(
        [requiring(wheel, ["preset"]), requiring(wheel, ["radius_m", "width_m"], without=["preset"])]
    )
    fields = ["cohesion_pa", "friction_angle_rad", "pressure_sinkage"]
    with_modulus = requiring(soil, [*fields, "shear_modulus_m"], without=["preset"])
    without_modulus = requiring(soil, [*fields, "shear"], without=["preset", "shear_modulus_m"])
    without_modulus["properties"]["shear"] = one_of(
        law for law in shear["oneOf"] if law["$ref"] != "#/components/schemas/JanosiHanamotoShear"
    )
    # Single values of a preset's law may stand without its word, which no schema tells; tests of the service have them.
    whole = {"enum": [{"preset": preset} for preset in PRESETS]}
    schemas["Soil"] = one_of([whole, with_modulus, without_modulus])
    dense = requiring(soil, ["friction_angle_rad", "bulk_density_kg_m3"], without=["preset", "granular_stiffness_n_m3"])
    dense["properties"]["friction_angle_rad"]["minimum"] = 1e-6  # without friction the stiffness has to be given
    stiff = requiring(soil, ["granular_stiffness_n_m3"], without=["preset", "bulk_density_kg_m3"])
    schemas["Grains"] = one_of(lawless(of) for of in (dense, stiff))
    measurements(schemas)
    exits(schemas)
    schemas["CoupledRequest"] = coupled(schemas["CoupledRequest"])
    schemas["OptimumRequest"] = searches(schemas["OptimumRequest"])
    within_a_request(schemas)

    # What the schema here no longer has would keep the example from being sent.
    compared = raw_schema["paths"]["/v1/compare"]["post"]["requestBody"]["content"]["application/json"]
    del compared["example"]["variants"]
    # Without a schema of their own, tables and lines of objects would be any text; tests of the service have them.
    track = raw_schema["paths"]["/v1/track"]["post"]
    del track["parameters"]
    track["requestBody"]["content"] = {"application/json": track["requestBody"]["content"]["application/json"]}
    del raw_schema["paths"]["/v1/batch"]
    # Distributions of any field of a request have rules among their fields that no schema tells.
    del raw_schema["paths"]["/v1/uncertainty"]
    for operations in raw_schema["paths"].values():
        asked = [with_its_content(raw_schema, parameter) for parameter in operations.get("get", {}).get("parameters", [])]
        if any("." in parameter["name"] for parameter in asked):
            operations["get"]["parameters"] = rover(asked) if "mass_kg" in {of["name"] for of in asked} else one_way(asked)
    null_is_absent([schema for name, schema in schemas.items() if not name.endswith(ANSWERED)])


def answers_as_they_stand(document):
    """Answers keep the contract's own schemas: the rules below are about requests only."""
    schemas = document["components"]["schemas"]
    answered = {name + ANSWERED: referring_to_answers(deepcopy(schema)) for name, schema in schemas.items()}
    for operations in document["paths"].values():
        for operation in operations.values():
            referring_to_answers(operation["responses"])
    for response in document["components"].get("responses", {}).values():
        referring_to_answers(response)
    schemas.update(answered)


def referring_to_answers(part):
    for inner in part.values() if isinstance(part, dict) else part:
        if isinstance(inner, (dict, list)):
            referring_to_answers(inner)
    if isinstance(part, dict) and str(part.get("$ref", "")).startswith("#/components/schemas/"):
        part["$ref"] += ANSWERED
    return part


def whole_laws(part):
    """Laws as a whole: single values of one need a preset that has it; tests of the service have them."""
    for inner in part.values() if isinstance(part, dict) else part:
        if isinstance(inner, (dict, list)):
            whole_laws(inner)
    if isinstance(part, dict) and isinstance(part.get("oneOf"), list):
        part["oneOf"] = [way for way in part["oneOf"] if not is_of_values(way.get("$ref", ""))]


def is_of_values(target):
    return target.endswith("Values") and not target.endswith("ContactValues")


def with_its_content(document, parameter):
    """A parameter, in place of a reference to one that operations share."""
    target = parameter.get("$ref")
    return deepcopy(document["components"]["parameters"][target.rpartition("/")[2]]) if target else parameter


def null_is_absent(schema):
    """Null for every field of a request that may be left out. Only requests refuse fields that they do not know."""
    for part in schema.values() if isinstance(schema, dict) else schema:
        if isinstance(part, (dict, list)):
            null_is_absent(part)
    if isinstance(schema, dict) and schema.get("additionalProperties") is False:
        fields = schema["properties"]
        for name in fields.keys() - set(schema.get("required", [])):
            fields[name] = {"anyOf": [fields[name], {"type": "null"}]}


def rovers(schema):
    """Rovers with wheels that are alike, with stations, and with stations in ruts, each on the soil of all, which has its laws."""
    schema = requiring(schema, [])
    # A range may have so many slopes that their price is refused; tests of the service have it.
    slope = schema["properties"]["slope_rad"]
    slope["oneOf"] = [way for way in slope["oneOf"] if not way.get("$ref", "").endswith("/SlopeRange")]
    schema["properties"]["method"]["enum"] = [method for method in schema["properties"]["method"]["enum"] if method != GRAINS]
    alike = requiring(schema, ["wheels", "soil"], without=["stations", "centre_of_mass", "rut", "unloading"])
    apart = requiring(schema, ["stations", "soil"], without=["wheels", "rut", "unloading"])
    in_ruts = requiring(schema, ["stations", "soil", "rut"], without=["wheels"])
    in_ruts["properties"]["rut"]["enum"] = [True]
    in_ruts["properties"]["method"]["enum"] = ["quadrature"]
    return [alike, apart, in_ruts]


def measurements(schemas):
    """Columns of one length, and fits that only ask for what every soil has beside those that ask for anything."""
    for name in ("FitData", "PlateColumns", "ShearColumns"):
        for column in schemas[name]["properties"].values():
            column["minItems"] = column["maxItems"] = 4
    for column in schemas["PlateColumns"]["properties"].values():
        column["items"]["minimum"] = 1e-6  # 0 is taken, but not in every row
    data = schemas["FitData"]
    load = requiring(data, ["normal_force_n", "torque_n_m"], without=["sinkage_m"])
    load["properties"]["normal_force_n"]["items"]["minimum"] = 1e-9
    schemas["FitData"] = one_of([requiring(data, ["sinkage_m", "torque_n_m"]), load])
    anything = schemas["IdentifyRequest"]
    idle = ["bounds", "start", "standard_deviation", "slip_sinkage", "estimator"]
    plain = requiring(anything, ["soil"], without=idle)
    plain["properties"]["fit"]["items"]["enum"] = ["cohesion_pa", "friction_angle_rad", "n0", "n1"]
    plain["properties"]["fit"]["maxItems"] = 4
    plain["properties"]["method"]["enum"] = [method for method in plain["properties"]["method"]["enum"] if method != GRAINS]
    schemas["IdentifyRequest"] = plain


def exits(schemas):
    """Contacts that end by c3, and those that end by the ratio of the sinkages."""
    # Without a rule it is the soil's, or midpoint, which has no c1 and c2.
    values = schemas["ContactValues"]
    schemas["ContactValues"] = {**values, "properties": {name: of for name, of in values["properties"].items() if name not in ("c1", "c2")}}
    for name in [*(reference["$ref"].rpartition("/")[2] for reference in schemas["Contact"]["oneOf"]), "ContactValues"]:
        contact = schemas[name]
        schemas[name] = one_of([requiring(contact, [], without=["exit"]), requiring(contact, ["exit"], without=["c3"])])


def between(field, low, middle, high):
    """A field that is uniform between a number below the middle and one above it."""
    below, above = {"type": "number", "minimum": low, "maximum": middle}, {"type": "number", "exclusiveMinimum": middle, "maximum": high}
    return closed({"field": {"enum": [field]}, "distribution": {"enum": ["uniform"]}, "low": below, "high": above})


def closed(fields):
    """An object that has these fields and no others."""
    return {"type": "object", "properties": fields, "required": list(fields), "additionalProperties": False}


def coupled(schema):
    """With a measured torque no soil is needed, without one it is. What says how to slip was chosen before."""
    of_each = [
        [requiring(way, ["soil"], without=["torque_n_m"]), requiring(way, ["torque_n_m"])] for way in schema["oneOf"]
    ]
    return one_of(way for ways in of_each for way in ways)


def searches(schema):
    """Searches of a wheel for two loads: which fields vary and which formulas are right depends on the request."""
    wheel = {"wheel": {"width_m": 0.1}, "soil": {"preset": "letter-sand"}, "slip": 0.2}
    quantities = ["torque_n_m", "sinkage_m", "-longitudinal_force_n", "2*pi*radius_m*0.002*2700", "drawbar_coefficient^2"]
    variable = {
        "type": "object",
        "additionalProperties": False,
        "required": ["field", "from", "to"],
        "properties": {
            "field": {"enum": ["/wheel/radius_m"]},
            "from": {"type": "number", "minimum": 0.05, "maximum": 0.1},
            "to": {"type": "number", "minimum": 0.2, "maximum": 0.3},
            "start": {"type": "number", "minimum": 0.1, "maximum": 0.2},
            "spacing": {"enum": ["linear", "log"]},
        },
    }
    limit = {"type": "number", "minimum": -1e3, "maximum": 1e3}
    constraint = {
        "type": "object",
        "additionalProperties": False,
        "required": ["quantity", "at_most"],
        "properties": {"quantity": {"enum": quantities}, "at_least": limit, "at_most": limit},
    }
    schema = requiring(schema, [])
    fields = schema["properties"]
    fields["of"] = {"enum": ["forces"]}
    fields["request"] = {"enum": [{**wheel, "normal_load_n": load} for load in (20, 60)]}
    fields["variables"] = {"type": "array", "items": variable, "minItems": 1, "maxItems": 1}
    fields["constraints"] = {"type": "array", "items": constraint, "maxItems": 2}
    fields["minimise"] = fields["maximise"] = {"enum": quantities}
    fields["evaluations"]["maximum"] = 200
    against = {"type": "object", "additionalProperties": False, "required": ["minimise"], "properties": {}}
    against["properties"] = {"minimise": {"enum": quantities}, "points": {"type": "integer", "minimum": 2, "maximum": 5}}
    fields["against"] = against
    return one_of([requiring(schema, ["minimise"], without=["maximise"]), requiring(schema, ["maximise"], without=["minimise"])])


# A request within a request: what it may be is tried at its own operation.
ASKED = {
    "forces": {"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "normal_load_n": 80},
    "vehicle": {"mass_kg": 20, "wheels": {"count": 4, "wheel": {"preset": "mer"}}, "soil": {"preset": "letter-sand"}, "slope_rad": 0.1},
}
VARIED = ["/wheel/width_m", "/soil/cohesion_pa", "/soil/pressure_sinkage/n0"]


def within_a_request(schemas):
    """One request for forces and one of a rover, whose fields vary by a range or a list."""
    schemas["SweepRequest"] = one_of(asked(schemas["SweepRequest"], of) for of in ASKED)
    axis = schemas["SweepAxis"]
    axis["properties"]["field"] = {"enum": VARIED}
    schemas["SweepAxis"] = one_of(
        [requiring(axis, ["from", "to", "points"], without=["values"]), requiring(axis, ["values"], without=["from", "to", "points", "spacing"])]
    )


def asked(schema, of):
    schema = requiring(schema, [])
    schema["properties"]["of"] = {"enum": [of]}
    schema["properties"]["request"] = {"enum": [ASKED[of]]}
    schema["properties"]["axes"]["maxItems"] = 1  # no field varies twice
    return schema


def samples(columns):
    """Columns of one length, with the time, and without a load beside the one that all samples have."""
    columns = requiring(columns, ["time_s"], without=["normal_load_n"])
    for column in columns["properties"].values():
        column["minItems"] = column["maxItems"] = 3
    return columns


def one_way(parameters):
    """A query that can be answered: parameters cannot exclude each other, so one way to each thing is left of them.

    What else there is meets the same checks as in a body; tests of the service compare the two.
    """
    given = ["wheel.preset", "soil.preset", "sinkage_m", "slip", "slip.from", "slip.to", "slip.points"]
    if "sinkage_m" not in {of["name"] for of in parameters}:
        given.append("normal_load_n")
    others = [name for group in (SINKAGE, SOLVED_SLIP) for way in group for name in way if name not in given]
    others += ["braking", *SIDEWAYS]
    tagged = ("contact.", "slip_sinkage.", "soil.pressure_sinkage.", "soil.shear.")
    kept = [of for of in parameters if of["name"] not in others and not of["name"].startswith(tagged)]
    for of in kept:
        if of["name"] == "method":  # few presets have a density
            of["schema"]["enum"] = [method for method in of["schema"]["enum"] if method != GRAINS]
    return [{**of, "required": of["name"] in given} for of in kept]


def rover(parameters):
    """A query for a rover with what it needs; tests of the service compare the rest with the body."""
    needed = ["mass_kg", "wheels.count", "wheels.wheel.preset", "soil.preset"]
    taken = {"soil.preset": {"enum": PRESETS}, "wheels.wheel.preset": {"enum": ["letter"]}, "mass_kg": {"enum": [20]}}
    kept = [of for of in parameters if of["name"] in [*needed, "slope_rad"]]
    return [{**of, "required": of["name"] in needed, "schema": taken.get(of["name"], of["schema"])} for of in kept]


def by_soil(schema):
    """The schema with the method of dry grains on a soil for it, and with the other methods on any other soil."""
    field = "methods" if has(schema, ["methods"]) else "method"
    if not has(schema, [field]):
        return [schema]
    grains, others = requiring(schema, [field]), requiring(schema, [])
    words = (lambda of: of["properties"]["methods"]["items"]) if field == "methods" else (lambda of: of["properties"]["method"])
    words(others)["enum"] = [method for method in words(others)["enum"] if method != GRAINS]
    words(grains)["enum"] = [GRAINS]
    grains["properties"]["soil"] = {"$ref": "#/components/schemas/Grains"}
    if field == "methods":
        others["properties"]["methods"]["maxItems"] -= 1
    if has(grains, ["braking"]):
        grains["properties"]["braking"]["enum"] = ["one_zone"]
        grains["properties"]["braking"].pop("default", None)
    if has(grains, SIDEWAYS):
        grains = requiring(grains, [], without=SIDEWAYS)
    return [grains, others]


def lawless(soil):
    """The soil with no law, which the method of dry grains does not miss; tests of the service have both."""
    for name in ("pressure_sinkage", "shear", "shear_modulus_m"):
        soil["properties"][name] = {"type": "null"}
    return soil


def is_of_grains(schema):
    words = schema["properties"].get("method") or schema["properties"].get("methods", {}).get("items", {})
    return words.get("enum") == [GRAINS]


def by_zones(schema):
    """The schema with one zone and any method, and with two zones and the quadrature."""
    if not has(schema, ["braking"]) or is_of_grains(schema):
        return [schema]
    one, two = requiring(schema, []), requiring(schema, ["braking"])
    one["properties"]["braking"]["enum"] = ["one_zone"]
    two["properties"]["braking"]["enum"] = ["two_zone"]
    if has(two, ["method"]):
        two["properties"]["method"]["enum"] = ["quadrature"]
    if has(two, ["methods"]):
        two["properties"]["methods"]["items"]["enum"] = ["quadrature"]
        two["required"].append("methods")
    return [one, two]


def has(schema, fields):
    return all(field in schema.get("properties", {}) for field in fields)


def one_of(variants):
    return {"oneOf": list(variants)}


def chosen(schema, groups, choice):
    """The schema with one alternative of each group required and the others gone."""
    given = [field for alternative in choice for field in alternative]
    others = [field for group in groups for alternative in group for field in alternative if field not in given]
    lonely = [field for field, other in BESIDE.items() if has(schema, [field]) and other not in given]
    return requiring(schema, given, [*others, *lonely])


def straight_or_sideways(schema):
    """The schema with a closed form, which has no lateral force, and with the quadrature, which has one unless of two zones."""
    if not has(schema, SIDEWAYS) or is_of_grains(schema):
        return [schema]
    if schema["properties"]["braking"]["enum"] == ["two_zone"]:
        return [requiring(schema, [], without=SIDEWAYS)]
    closed, integrated = requiring(schema, ["method"], without=SIDEWAYS), requiring(schema, [])
    # Apart from each other: a request that fits both would fit neither.
    closed["properties"]["method"]["enum"] = [method for method in schema["properties"]["method"]["enum"] if method != "quadrature"]
    integrated["properties"]["method"]["enum"] = ["quadrature"]
    return [closed, integrated]


def requiring(schema, fields, without=()):
    assert schema["additionalProperties"] is False, "only then is a field that is not listed refused"
    assert has(schema, [*fields, *without]), f"the contract lacks some of {fields} and {without}"
    variant = deepcopy(schema)
    variant["required"] = [*schema.get("required", []), *fields]
    for name in without:
        if name in LEFT_OUT:
            del variant["properties"][name]
        else:
            # Another variant has it, where null makes this one of it.
            variant["properties"][name] = {"enum": [None, *NEUTRAL.get(name, [])]}
    return variant


@schemathesis.hook
def before_call(context, case, kwargs):
    """Asks for the table instead of JSON in half of the requests that offer it, the same half in every run."""
    answers = case.operation.definition.raw.get("responses", {}).get("200", {}).get("content", {})
    if "text/csv" in answers and len(json.dumps(sent(case), default=str)) % 2:
        case.headers = {**(case.headers or {}), "Accept": "text/csv"}


@schemathesis.check
def refuses_only_what_the_schema_cannot_say(ctx, response, case):
    if response.status_code != 422 or not case.meta.generation.mode.is_positive:
        return
    for fault in response.json()["errors"]:
        detail = fault["detail"]
        if fault["pointer"].startswith("/axes/"):
            continue  # the bounds of an axis are those of its field
        if fault["pointer"].endswith(FOLLOWS) and detail == "is required":
            continue
        if detail.startswith(IN_THE_SCHEMA) and not detail.startswith(NOT_PUBLISHED):
            raise AssertionError(f"The schema allows what the service refuses: {fault['pointer']} {detail}")


@schemathesis.check
def a_problem_tells_the_truth(ctx, response, case):
    """The status is the one sent, and every pointer leads to a field, or to where one is missing."""
    if response.status_code < 400 or case.method == "HEAD":
        return
    problem = response.json()
    assert problem["status"] == response.status_code, f"the document says {problem['status']}"
    if response.status_code == 422:
        assert problem["errors"], "a refusal names no fault"
    for fault in problem.get("errors", []):
        assert leads_somewhere(fault["pointer"], sent(case)), f"{fault['pointer']} does not exist in the request"


def sent(case):
    """The body, or the one that a query stands for, as far as names go."""
    if case.method == "POST":
        return case.body
    body = {}
    for name in case.query or {}:
        place = body
        for part in name.split("."):
            # A name may stand for a value and for fields below it, as in `soil=1&soil.preset=letter-sand`.
            place = place.setdefault(part, {})
    return body


def leads_somewhere(pointer, body):
    if pointer == "":
        return True
    *around, last = [part.replace("~1", "/").replace("~0", "~") for part in pointer.split("/")[1:]]
    place = body
    for part in around:
        if isinstance(place, list):
            place = place[int(part)] if int(part) < len(place) else None
        else:
            place = place.get(part) if isinstance(place, dict) else None
    return isinstance(place, dict) or (isinstance(place, list) and int(last) < len(place))


@schemathesis.check
def columns_are_complete(ctx, response, case):
    """Columns have one length, and hold finite numbers or nothing."""
    if response.status_code != 200 or not (case.method == "POST" or case.query):
        return
    if case.operation.path in ("/v1/wheels", "/v1/soils"):
        return  # tables of words
    if response.headers["content-type"][0].startswith("text/csv"):
        lines = (line for line in io.StringIO(response.text, newline="") if not line.startswith("#"))
        names, *rows = csv.reader(lines)
        assert rows, "the table has no rows"
        assert all(len(row) == len(names) for row in rows), "a row of the table is too short or too long"
        cells = [cell for row in rows for name, cell in zip(names, row) if cell and name not in WORDS]
    else:
        columns = list(named_columns(json.loads(response.content, parse_constant=not_a_number).get("columns", {})))
        assert len({len(column) for _, column in columns}) <= 1, "the columns differ in length"
        numbers = [column for name, column in columns if name not in WORDS]
        cells = [cell for column in numbers for cell in column if cell is not None]
    assert all(math.isfinite(float(cell)) for cell in cells), "a cell is not a finite number"


def named_columns(columns):
    """The columns of an answer, also those that stand in groups."""
    for name, column in columns.items():
        if isinstance(column, dict):
            yield from named_columns(column)
        else:
            yield name, column


def not_a_number(text):
    raise AssertionError(f"{text} is not JSON")
