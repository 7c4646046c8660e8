//! The table of findings: to add one is to add an entry, and to raise it where it is found.

use std::borrow::Cow;

use terramechanics::Nearest;
use terramechanics_identification::{DesignGap, StopReason};
use terramechanics_uncertainty::Bounds;

use super::Measure;
use super::figure::Figure;
use super::pieces::{BeyondRange, gap_advice, gap_of};
use super::words::{Reason, counted, in_ruts, listed, listed_in_short, quoted, told_names};
use crate::catalogue::{CATALOGUE, Outside};
use crate::quantity::number;
use crate::quantity::with_unit;
use crate::series::SeriesFault;

/// A finding as `/v1/model` describes it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Note {
    pub(crate) code: &'static str,
    pub(crate) meaning: &'static str,
}

/// Declares the findings: code and name with the data of each, what it means, and two texts that are made of the data: what
/// holds, and what to do, in which no figure of a request stands. `$many` says whether it holds for several rows. A finding may
/// have a value that it is about, a field, names of fields, the end of a range at which the value lies, and a further figure.
macro_rules! findings {
    ($many:ident; $(
        $code:literal $name:ident { $($data:ident: $type:ty),* $(,)? }
        means $meaning:literal
        $(about $measure:expr,)?
        $(field $pointer:expr,)?
        $(names $names:expr,)?
        $(at $end:expr,)?
        $(figure $figure:expr,)?
        says $said:expr,
        advises $advice:expr;
    )+) => {
        /// Something that a result has to report about itself.
        #[derive(Debug, Clone, PartialEq)]
        pub(crate) enum Finding {
            $(#[doc = $meaning] $name { $($data: $type),* },)+
        }

        /// All findings there are.
        pub(crate) const NOTES: &[Note] = &[$(Note { code: $code, meaning: $meaning }),+];

        #[allow(unused_variables, reason = "few findings use all of their data for one thing")]
        impl Finding {
            /// Its name for programs.
            pub(crate) fn code(&self) -> &'static str {
                match self { $(Self::$name { .. } => $code,)+ }
            }

            /// The value that it is about.
            pub(super) fn measure(&self) -> Option<Measure> {
                match self { $(Self::$name { $($data),* } => None$(.or($measure.into()))?,)+ }
            }

            /// The field of the request to look at.
            pub(super) fn pointer(&self) -> Option<&str> {
                match self { $(Self::$name { $($data),* } => None$(.or(Some($pointer)))?,)+ }
            }

            /// The fields of request or answer that it names.
            pub(super) fn names(&self) -> Vec<Cow<'static, str>> {
                match self { $(Self::$name { $($data),* } => None$(.or(Some(told_names($names))))?.unwrap_or_default(),)+ }
            }

            /// The end of the range at which the value lies.
            pub(super) fn end(&self) -> Option<&'static str> {
                match self { $(Self::$name { $($data),* } => None$(.or(Some($end)))?,)+ }
            }

            /// A further figure of what holds.
            pub(super) fn figure(&self) -> Option<Figure> {
                match self { $(Self::$name { $($data),* } => None$(.or($figure.into()))?,)+ }
            }

            /// What holds, without its place.
            pub(super) fn finding(&self, $many: bool) -> String {
                match self { $(Self::$name { $($data),* } => $said.into(),)+ }
            }

            /// What to do.
            pub(super) fn advice(&self, $many: bool) -> String {
                match self { $(Self::$name { $($data),* } => $advice.into(),)+ }
            }
        }
    };
}

findings! { many;
    "mirrored" Mirrored {}
    means "The wheel moves backwards. Angles, stresses and slip are those of its mirror image; forces along x and the torque keep the axes of the rover."
    says "the wheel moves backwards.",
    advises "Angles, stresses and slip are those of its mirror image; forces along x and the torque keep the axes of the rover, with x \
             forward, and have changed sign.";

    "at_rest" AtRest {}
    means "Both velocities are 0: the wheel stands. Its slip is not defined; it is counted as rolling, with slip 0."
    field "/forward_velocity_m_s",
    says "both velocities are 0, so that the wheel stands and has no slip; it is counted as 0, that of a rolling wheel.",
    advises "A wheel that stands gives any pull up to its limits; send the slip of one that moves.";

    "not_used" NotUsed { pointers: Vec<String> }
    means "Fields of the request that the method does not read, so that no force depends on them: which, in `names`, as JSON pointers. What a preset has is not told."
    field pointers.first().map_or("", String::as_str),
    names pointers.clone(),
    says format!(
        "the method does not read {}: no force depends on {}.",
        listed_in_short(pointers),
        if pointers.len() == 1 { "it" } else { "them" }
    ),
    advises "Leave out what is not read, or choose a method that reads it; `/v1/model` says what each needs.";

    "outside_catalogue" OutsideCatalogue { outside: Outside }
    means "A value of the wheel or the soil is more than three times beyond the extremes of the catalogue, or a friction angle is beyond them at all. It may be right, or it may be in another unit."
    about {
        let extent = outside.extent;
        Measure::of(&extent.quantity, outside.value).in_unit(extent.unit).beyond(extent.lower, Some(extent.upper), CATALOGUE)
    },
    field &outside.extent.pointer,
    says {
        let extent = outside.extent;
        let (side, extreme) = match extent.lower {
            Some(lower) if outside.value < lower => ("below the smallest value above 0", lower),
            _ => ("above the largest value", extent.upper),
        };
        let far = if extent.is_exact() { "" } else { "far " };
        let (value, extreme) = (with_unit(outside.value, extent.unit), with_unit(extreme, extent.unit));
        format!("{} is {value}, {far}{side} in the catalogue, {extreme}.", extent.quantity)
    },
    advises "Check its unit.";

    "assumed_values" AssumedValues { values: Vec<(String, String, f64)> }
    means "Values of a preset that were never published were assumed, as the request allowed: which, of which preset, and with what value. The answer lists under `assumed` where each comes from."
    field "/assume",
    says {
        let values: Vec<String> = values.iter().map(|(field, preset, value)| format!("`{field}` of `{preset}` = {}", number(*value))).collect();
        format!("never published and assumed: {}.", listed(&values))
    },
    advises "Look under `assumed` where each value comes from, and send your own where it is known.";

    "invalid_row" InvalidRow { pointer: String, detail: String }
    means "The values of some rows make no request that could be computed: which rows, and what is wrong with the first."
    field pointer.as_str(),
    says {
        let place = if pointer.is_empty() { String::new() } else { format!("`{pointer}` ") };
        format!("the values make no request{}: {place}{detail}.", if many { ". That of the first" } else { "" })
    },
    advises "Correct these values or leave them out.";

    "truncated_distribution" TruncatedDistribution { pointer: String, field: String, share: f64, bounds: Bounds }
    means "Part of the distribution of an uncertain field lies outside what the field may be and is cut off: which share. The rest grows to 1, so that mean and deviation are no longer those that were sent."
    about Measure::of("share_cut", *share),
    field pointer.as_str(),
    says format!(
        "a share of {} of the distribution of `{field}` lies outside what the field may be, {bounds}, and is cut off.",
        number(*share)
    ),
    advises "Send a lognormal or triangular distribution, or quantiles, if that share is not small.";

    "samples_unanswered" SamplesUnanswered { count: u64, all: u64 }
    means "Samples of an uncertain request have no answer: how many. A band is made of the samples that have a value, so that it holds on condition that there is one."
    about Measure::of("unanswered", *count as f64).in_unit("1"),
    says format!("{count} of {all} samples have no answer; `answered` tells how many samples each band has."),
    advises "`status` counts why; `least` and `most` of a probability take them into account. Narrow the inputs if they are many.";

    "no_solution" NoSolution { reason: Reason, pointer: &'static str }
    means "Points of a sweep or samples of a track have no solution: which, and why the first has none."
    about reason.measure(),
    field pointer,
    figure reason.figure(),
    says format!("no solution{} because {}.", if many { ". The first has none" } else { "," }, reason.in_words()),
    advises {
        let points = if many { "these points" } else { "this point" };
        if pointer.is_empty() { format!("Leave {points} out.") } else { format!("Change `{pointer}`, or leave {points} out.") }
    };

    "not_climbed" NotClimbed { needed: f64, reached: f64, slip: f64, nearest: Nearest }
    means "No slip gives the pull that the slope and the hitch of a rover need: the pull needed, and the one that comes nearest."
    about {
        let bound = |of: Nearest| (*nearest == of).then_some(*reached);
        Measure::of("needed_pull_n", *needed).beyond(bound(Nearest::Least), bound(Nearest::Largest), "the pull at slips from -1 to 1")
    },
    field "/slope_rad",
    figure Figure::of("slip", *slip, "1"),
    says format!(
        "no slip gives the {} that slope and hitch need{}: {} pull is {}, at a slip of {}.",
        with_unit(*needed, "N"),
        if many { " on the first of these slopes" } else { "" },
        nearest.in_words(),
        with_unit(*reached, "N"),
        number(*slip)
    ),
    advises "`largest_slope_rad` has the largest slope that the rover climbs.";

    "rut_too_narrow" RutTooNarrow { stations: Vec<(usize, usize)>, ratio: f64 }
    means "A wheel of a rover is wider than the one in whose rut it runs: which stations, and how much wider. The rut is taken to be as wide as the wheel in it; in truth undisturbed soil carries the wheel beside the rut."
    about Measure::of("width over that of the wheel ahead", *ratio).in_unit("1").beyond(None, Some(1.0), "the rut that the wheel ahead presses"),
    field "/stations",
    names stations.iter().map(|(station, _)| format!("/stations/{station}")).collect(),
    says format!(
        "{}, up to {} times as wide, and the rut is taken to be as wide as the wheel in it.",
        in_ruts(stations, ["is wider than", "are wider than"]),
        number(*ratio)
    ),
    advises "Undisturbed soil beside the rut would carry such a wheel earlier and resist it more: its sinkage is taken too large and its \
             resistance too small. Compute without `rut` as well; the truth lies between.";

    "rut_of_other_soil" RutOfOtherSoil { stations: Vec<(usize, usize)> }
    means "A wheel of a rover runs in the rut of one on another soil: which stations. The depth is that which the wheel ahead pressed into its own soil; pressure and strength are those of the follower's."
    field "/stations",
    names stations.iter().map(|(station, _)| format!("/stations/{station}")).collect(),
    says format!(
        "{}, and the rut is taken to be as deep as there.",
        in_ruts(stations, ["stands on another soil than", "stand on another soil than"])
    ),
    advises "One soil under all wheels of a track is what ruts are meant for. Compute without `rut` as well.";

    "slip_beyond_limit" SlipBeyondLimit { slip: f64, limit: f64 }
    means "A rover climbs a slope only with more slip than the limit."
    about Measure::of("slip", *slip).in_unit("1").beyond(None, Some(*limit), "`slip_limit` of the request"),
    field "/slip_limit",
    says format!("the rover climbs only with a slip of {}, above the limit {}.", number(*slip), number(*limit)),
    advises "Take care: a rover that slips so much digs itself in. `largest_slope_rad` has the largest slope below the limit.";

    "wheel_lifts" WheelLifts { station: usize, load: f64, slope: f64 }
    means "By statics a wheel of a rover would have to pull the ground up: it lifts off, and the rover tips over."
    about Measure::of("normal_load_n", *load).beyond(Some(0.0), None, "statics of a rigid body"),
    field "/centre_of_mass",
    figure Figure::of("slope", *slope, "rad"),
    says format!(
        "the wheel of station {station} lifts off on a slope of {}: statics ask for a load of {} there.",
        with_unit(*slope, "rad"),
        with_unit(*load, "N")
    ),
    advises "Lower the centre of mass, move it uphill, or set the wheels further apart.";

    "climb_ends_by_wheel" ClimbEndsByWheel { reason: String }
    means "The largest slope is where a wheel lifts off or has no answer, not where the pull ends."
    field "/centre_of_mass",
    says format!("the largest slope is not where the pull ends, because on a steeper one {reason}."),
    advises "With other loads the rover may climb further.";

    "climbs_everything" ClimbsEverything { slope: f64 }
    means "The rover climbs every slope that is tried."
    about Measure::of("slope_rad", *slope),
    says format!("the rover climbs every slope up to {}, the largest that is tried.", with_unit(*slope, "rad")),
    advises "Check the cohesion and the friction angle: no loose soil is that strong.";

    "no_largest_slope" NoLargestSlope { reason: String }
    means "There is no slope that the rover climbs, level ground and descents included."
    says format!("`largest_slope_rad` is null, because {reason}."),
    advises "Check the mass, the soil and the pull at the hitch.";

    "missing_value" MissingValue { columns: Vec<(&'static str, u64)> }
    means "Samples of a track lack a value: how many, the first, and which value."
    names columns.iter().map(|(name, _)| *name).collect(),
    says {
        let columns: Vec<String> =
            columns.iter().map(|(name, count)| format!("`{name}` in {}", counted(*count, "sample", "samples"))).collect();
        format!("no result, because a value is missing: {}.", listed(&columns))
    },
    advises "Fill the gaps if the values are known.";

    "unreadable" Unreadable { values: u64, first: SeriesFault }
    means "Values of a track are not numbers and were taken as missing: how many, with line, column and text of the first."
    says format!("{} {first}.", counted(*values, "value is not a number, at", "values are not numbers, the first at")),
    advises "Write numbers, and leave a cell empty where there is none.";

    "missing_torque" MissingTorque {}
    means "Samples of a track have a result, but no pull by the coupled form and no part in the estimate of the strength, because the measured torque is missing."
    names vec!["torque_n_m"],
    says "no pull by the coupled form, because `torque_n_m` is missing.",
    advises "Fill the gaps if the torque is known.";

    "missing_load" MissingLoad {}
    means "Samples of a track have a result, but no pull by the coupled form and no part in the estimate of the strength, because the load is missing."
    names vec!["normal_load_n"],
    says "no pull by the coupled form, because `normal_load_n` is missing.",
    advises "Fill the gaps if the load is known.";

    "out_of_range" OutOfRange { values: Vec<BeyondRange> }
    means "Samples of a track have an infinite value, a load or sinkage that is not greater than 0, or a measured sinkage beyond the radius: which value, its range, and the first."
    about {
        let BeyondRange { column, first, lower, upper, .. } = values.first().copied().unwrap_or_default();
        Measure::of(column, first).beyond(lower, upper, "the request and the geometry of the wheel")
    },
    says {
        let said: Vec<String> = values.iter().map(BeyondRange::in_words).collect();
        format!("no result. {}", said.join(" "))
    },
    advises if values.iter().any(BeyondRange::is_beyond_radius) { "Send metres." } else { "Check the values and their units." };

    "slip_out_of_range" SlipOutOfRange { first: f64, largest: f64 }
    means "Samples of a track have a slip that is not from −1 to 1. One in per cent has to be divided by 100."
    about Measure::of("slip", *first).in_unit("1").beyond(Some(-1.0), Some(1.0), "the definition of slip"),
    says format!("no result, because the slip has to be from -1 to 1 and the first is {}.", number(*first)),
    advises if *largest <= 100.0 { "Divide by 100 if the column is in per cent." } else { "Check the column." };

    "opposite_rotation" OppositeRotation { reason: Reason }
    means "Samples of a track have velocities of opposite signs."
    says format!("no result, because {}.", reason.in_words()),
    advises "Check the signs of both velocities.";

    "time_backwards" TimeBackwards {}
    means "Samples of a track are earlier than the sample before. No energy is added there."
    says "no result, because the time is before that of the sample before.",
    advises "No energy is added there; sort the samples by time.";

    "not_coupled" NoLoad {}
    means "A torque is measured, but no load is known, so there is no pull by the coupled form."
    field "/normal_load_n",
    says "no pull by the coupled form, because a torque is measured but no load is known.",
    advises "Give `normal_load_n`.";

    "not_coupled" NotCoupled { reason: Reason }
    means "Samples of a track have a torque, but no pull by the coupled form, because none goes with their load."
    about reason.measure(),
    figure reason.figure(),
    says format!("no pull by the coupled form, because {}.", reason.in_words()),
    advises "Check torque and load.";

    "events_left_out" EventsLeftOut { events: u64 }
    means "A track has more events than are listed."
    says format!("{} not listed.", counted(*events, "more event is", "more events are")),
    advises "Split the track to see all.";

    "points_raised" PointsRaised { points: usize }
    means "A profile has at least the exit, the peak and the entry."
    field "/points",
    says format!("the profile has {points} points, because exit, peak and entry are always among them."),
    advises "Ask for at least as many.";

    "needs_exponent_below_three" NeedsExponentBelowThree { estimate: &'static str, exponent: f64 }
    means "Classical estimates are null because the sinkage of the rigid wheel has the factor 3 − n."
    about Measure::of("sinkage exponent n0", *exponent).in_unit("1").beyond(None, Some(3.0), "Bekker's sinkage of a rigid wheel"),
    field "/soil/pressure_sinkage/n0",
    says format!("`{estimate}` is null, because Bekker's rigid wheel needs a sinkage exponent below 3, not {}.", number(*exponent)),
    advises "Use another soil or the integrated forces.";

    "needs_unit_weight" NeedsUnitWeight { estimate: &'static str }
    means "The bulldozing resistance is null because the soil has no unit weight."
    about Measure::without_value(estimate),
    field "/soil/unit_weight_n_m3",
    says format!("`{estimate}` is null, because the soil has no unit weight."),
    advises "Give `unit_weight_n_m3`.";

    "needs_driving_slip" NeedsDrivingSlip { estimate: &'static str }
    means "The thrust is null because no slip greater than 0 was given."
    about Measure::without_value(estimate),
    field "/slip",
    says format!("`{estimate}` is null, because it needs a slip greater than 0."),
    advises "Give `slip`.";

    "needs_janosi_hanamoto" NeedsJanosiHanamoto { estimate: &'static str }
    means "The thrust is null because it is known for Janosi–Hanamoto's shear law only."
    about Measure::without_value(estimate),
    field "/soil/shear",
    says format!("`{estimate}` is null, because it is known for Janosi–Hanamoto's shear law only."),
    advises "Use that law with a `shear_modulus_m`.";

    "no_linear_stresses" NoLinearStresses {}
    means "The linear stresses of a profile with two zones are null, because no shear stress acts at the peak."
    field "/braking",
    says "the linear stresses are null: no shear stress acts at the peak of a braking wheel with two zones.",
    advises "Choose `one_zone` to get them.";

    "no_linear_stresses" NoLinearStressesInGrains {}
    means "The linear stresses of a profile by the method resistive_force are null, because it has no linear form."
    field "/method",
    says "the linear stresses are null: the method `resistive_force` has no linear form.",
    advises "Use the quadrature to get them.";

    "not_converged" NotConverged { stop: StopReason }
    means "The search for parameters ended before a minimum; stop_reason says why."
    says match stop {
        StopReason::Budget => "the search ran out of evaluations or time.",
        StopReason::ModelRefuses => "the search reached values for which the model has no answer.",
        StopReason::NotFinite => "the search ended because a number overflowed.",
        StopReason::NoFurtherDecrease | StopReason::SmallStep | StopReason::Stationary | StopReason::ExactFit => {
            "the search ended at a minimum."
        }
    },
    advises match stop {
        StopReason::Budget => "Fit fewer parameters, send fewer samples or start nearer to the solution.",
        StopReason::ModelRefuses => "Set `bounds`, another `start` or more `starts`.",
        StopReason::NotFinite => "Check the units of the data (SI).",
        StopReason::NoFurtherDecrease | StopReason::SmallStep | StopReason::Stationary | StopReason::ExactFit => {
            "Nothing needs to be done."
        }
    };

    "infeasible" Infeasible { missed: Vec<String> }
    means "No point was found within the bounds of an optimum that keeps all constraints: which ones the point of the answer misses, and by how much."
    says format!("no point was found that keeps all constraints; this one misses {}.", listed(missed)),
    advises "It is no design to be built: of all points it misses the constraints least. `met_alone` of a constraint tells whether another point meets it. \
             Loosen a constraint or widen the bounds.";

    "not_converged" SearchUnfinished {}
    means "The search for an optimum spent its evaluations before it ended by itself: of which points, where there are several."
    field "/evaluations",
    says if many { "the searches of these points spent their evaluations." } else { "the search spent its evaluations." },
    advises "A better point may be near. Raise `evaluations`, take fewer `starts`, or narrow the bounds.";

    "not_converged" LineNotSolved {}
    means "The line of the linear estimator could not be solved, because its numbers differ too much in size."
    says "the line could not be solved, because its numbers differ too much in size.",
    advises "Check the units of the data (SI).";

    "not_identifiable" NotIdentifiable { parameters: Vec<&'static str> }
    means "The data do not determine all parameters; each estimate says in words what is known of it."
    names parameters.clone(),
    says format!("the data do not determine {}.", quoted(parameters)),
    advises format!(
        "Hold {} fixed or measure under other conditions; `identifiability` says why.",
        if parameters.len() == 1 { "it" } else { "one of them" }
    );

    "not_identifiable" NoEstimate {}
    means "A track has no estimate of the strength, because no two of its samples differ enough."
    says "there is no estimate of the strength.",
    advises "It takes two samples that mobilise enough of the strength under different normal stresses. Drive with different loads or \
             sinkages.";

    "single_slip" SingleSlip { parameters: Vec<&'static str> }
    means "All samples have one slip. Only the assumed shape of the stresses tells K from c and φ, n0 from n1 and c1 from c2."
    names parameters.clone(),
    says gap_of(DesignGap::OneSlip, parameters),
    advises gap_advice(DesignGap::OneSlip);

    "single_slip" SingleSlipOfLine {}
    means "All samples of a linear estimate have one slip. K is taken as known; a wrong K changes both estimates by the same factor, and the fit does not show it."
    field "/soil/shear_modulus_m",
    says "all samples have one slip.",
    advises "`shear_modulus_m` is taken as known; a wrong value changes both parameters by the same factor, and the fit does not show \
             it. Measure at other slips as well.";

    "single_slip" SingleSlipOfTrack { rows: u64, estimates: u64 }
    means "The samples that a running estimate remembers have one slip. A wrong K changes both estimates by the same factor, and the estimate does not show it."
    field "/soil/shear_modulus_m",
    says format!("in {rows} of {estimates} rows with an estimate, the samples that are remembered have one slip."),
    advises "A wrong `shear_modulus_m` changes both estimates by the same factor, and the estimate does not show it. Drive with other \
             slips as well.";

    "single_load" SingleLoad { parameters: Vec<&'static str> }
    means "All samples have one load, measured or, where the normal force was not measured, predicted by the model. Only the assumed shape of the stresses tells c from φ and the sinkage modulus from n0."
    names parameters.clone(),
    says gap_of(DesignGap::OneLoad, parameters),
    advises gap_advice(DesignGap::OneLoad);

    "single_load" SingleLoadOfTrack { rows: u64, estimates: u64 }
    means "The samples that a running estimate remembers have one load. Only the assumed shape of the stresses tells c from φ."
    says format!(
        "in {rows} of {estimates} rows with an estimate, the samples that are remembered have one load, so that only the assumed \
         shape of the stresses tells cohesion from friction."
    ),
    advises "Drive with other loads as well.";

    "normal_force_only" NormalForceOnly { parameters: Vec<&'static str> }
    means "Only the normal force is fitted, to which the shear stress adds little. c, φ and K are not determined."
    names parameters.clone(),
    says gap_of(DesignGap::NormalForceOnly, parameters),
    advises gap_advice(DesignGap::NormalForceOnly);

    "few_points" FewPoints { parameters: Vec<&'static str> }
    means "The samples repeat too few operating points to determine that many parameters."
    names parameters.clone(),
    says gap_of(DesignGap::FewPoints, parameters),
    advises gap_advice(DesignGap::FewPoints);

    "at_bound" AtBound { parameter: &'static str, end: &'static str, bound: f64 }
    means "An estimate lies at its bound, which decides its value."
    about Measure::of(parameter, *bound),
    at *end,
    says format!("`{parameter}` lies at its {end} bound {}, which decides its value.", number(*bound)),
    advises "Widen the bound if the soil allows it.";

    "at_bound" HeldAtZero { parameter: &'static str, rows: u64, estimates: u64 }
    means "A running estimate of the strength is held at 0 and has no variance."
    about Measure::of(parameter, 0.0),
    at "lower",
    says format!("in {rows} of {estimates} rows with an estimate, `{parameter}` is held at its lower bound 0 and has no variance."),
    advises "Check torque, load and `shear_modulus_m`.";

    "model_misfit" ModelMisfit { ratio: f64 }
    means "The residuals are more than twice what the given standard deviations allow."
    says format!(
        "the residuals are {} times what the standard deviations allow: the model does not describe the data that well.",
        number(*ratio)
    ),
    advises "The stated errors are widened by that factor. Check units, wheel, method and standard deviations.";

    "deviations_too_large" DeviationsTooLarge {}
    means "The residuals are less than half of what the given standard deviations allow."
    says "the residuals are less than half of what the standard deviations allow, so these are too large.",
    advises "Only their ratios are used, and the errors follow from the residuals. Send smaller standard deviations.";

    "column_missed" ColumnMissed { column: &'static str, rmse: f64, share: f64 }
    means "The residuals of a fitted column are more than a tenth of its size and more than a third of its spread (rms)."
    about Measure::of(column, *rmse),
    figure Figure::of("share of its size", *share, "1"),
    says format!(
        "the model with these values misses `{column}` by {} (rms), {:.0} % of its size.",
        number(*rmse),
        100.0 * share
    ),
    advises "Check the units, the wheel and the method.";

    "implausible_estimate" ImplausibleEstimate { parameter: &'static str, value: f64, least: Option<f64>, largest: Option<f64>, alike: bool }
    means "An estimate is more than ten times beyond what the soils of the catalogue have, moduli compared at like exponents, or a friction angle is beyond 60 degrees. The usual cause is a wrong unit."
    about Measure::of(parameter, *value).beyond(*least, *largest, CATALOGUE),
    says {
        let value = number(*value);
        let soils = if *alike { "soils of like exponent" } else { "soils" };
        let beyond = match (least, largest) {
            (Some(least), Some(largest)) => {
                format!("where the {soils} of the catalogue have {} to {} in size", number(*least), number(*largest))
            }
            (Some(least), None) => format!("where the {soils} of the catalogue have {} or more", number(*least)),
            _ => "beyond 60 degrees, which no soil has".to_owned(),
        };
        format!("`{parameter}` is {value}, {beyond}.")
    },
    advises "Check the units of the data (SI).";

    "beyond_measured" BeyondMeasured { parameter: &'static str, value: f64, low: f64, high: f64, preset: &'static str }
    means "The interval of an estimate lies beyond the range that was published for the soil that the request names."
    about Measure::of(parameter, *value).beyond(Some(*low), Some(*high), CATALOGUE),
    names vec![*preset],
    says format!("`{parameter}` is {}, and {} to {} was measured for `{preset}`.", number(*value), number(*low), number(*high)),
    advises "The soil may be another one, or the wheel may show another thing of it: a bare rim shows its interface with the soil.";

    "may_be_the_interface" MayBeTheInterface { parameters: Vec<&'static str> }
    means "The wheel has no lugs: a bare rim slips on the grains before the soil shears in itself, so that the strength and the shear modulus that a fit finds may be those between rim and soil."
    field "/contact",
    names parameters.clone(),
    says format!(
        "the wheel has no lugs, so that {} may belong to the interface of rim and soil. The soil by itself is stronger and shears over \
         a longer way.",
        quoted(parameters)
    ),
    advises "Use the values for wheels like this one, or give those of the soil and fit `interface_friction_angle_rad` and \
             `interface_shear_modulus_m`.";

    "law_replaced" LawReplaced {}
    means "`k_s` is fitted, so the law `direct` replaces that of the preset."
    says "`k_s` is fitted, so the law `direct` replaces that of the preset and keeps its exponents.",
    advises "Fit `k_c` and `k_phi` to keep Bekker's law.";

    "samples_left_out" SamplesLeftOut { left_out: usize, samples: usize }
    means "Samples that mobilise less than 5 % of the strength do not enter the linear estimate."
    says format!("{left_out} of {samples} samples mobilise too little of the strength to show it and were left out."),
    advises "Measure at higher slips.";

    // The figures are those of `benches/linear_bias.py`.
    "linearised_stresses" LinearisedStresses {}
    means "Every linear estimate carries this: its errors cover noise alone, and the assumption of linear stresses biases it. From noise-free forces of the quadrature on 663 pairs of a wheel and a soil of the catalogue, at loads of 1 to 8 kPa over width and diameter and slips of 0.1 to 0.6, it found a cohesion of up to 2.9 times the true one (median 1.9) or none, and a friction angle up to 4.5° too small (median 1.2°); in 28 of them both intervals of 95 % held the truth."
    field "/estimator",
    says "the linear estimator takes the stresses as linear, which they are not, and its errors cover noise alone.",
    advises "From noise-free forces of the quadrature on the wheels and soils of the catalogue it found a cohesion of up to 2.9 times \
             the true one (median 1.9) or none, and a friction angle up to 4.5° too small (median 1.2°); in 28 of 663 cases both \
             intervals of 95 % held the truth. Use the nonlinear estimator where this matters.";

    "model_bias" ModelBias { parameter: &'static str, bias: f64, half_width: f64 }
    means "Simulated with the soil's pressure–sinkage law, linear stresses shift a linear estimate by more than half the width of its interval."
    about Measure::of(parameter, *bias),
    field "/estimator",
    figure Figure::of_parameter("half width of the interval", *half_width, parameter),
    says format!(
        "simulated with the soil's pressure–sinkage law, linear stresses shift `{parameter}` by {}, more than half the width of its \
         interval, {}.",
        number(*bias),
        number(*half_width)
    ),
    advises "Use \"estimator\": \"nonlinear\" with the quadrature.";

    "fitted_k_c_negative" FittedCohesiveModulusNegative { least_width: f64, narrowest: f64 }
    means "Plate tests gave k_c < 0: the law holds only for widths above −k_c/k_phi."
    about Measure::of("width_m", *narrowest).beyond(Some(*least_width), None, "the fitted law"),
    says format!(
        "`k_c` is negative, which least squares may give. The law then holds only for widths above {} m; the narrowest plate has {} m.",
        number(*least_width),
        number(*narrowest)
    ),
    advises "Do not use it for narrower wheels.";

    "exponents_differ" ExponentsDiffer { least: f64, largest: f64 }
    means "The plates' own exponents differ by more than a fifth of the common one."
    says format!(
        "the plates' own exponents run from {} to {}, so one exponent does not describe them.",
        number(*least),
        number(*largest)
    ),
    advises "Fit plates near the width of the wheel.";

    "rows_without_sinkage" RowsWithoutSinkage { rows: usize }
    means "Rows of a plate test at zero sinkage were left out, because the law says nothing about the moduli there."
    says format!(
        "{} left out, because the law says nothing about the moduli there.",
        counted(*rows as u64, "row at zero sinkage was", "rows at zero sinkage were")
    ),
    advises "Nothing needs to be done.";

    "law_not_usable" LawNotUsable {}
    means "Plate tests gave a k_phi or an n0 that is not positive."
    says "`k_phi` or `n0` is not positive, and no soil has such a law.",
    advises "Check the units and the curves of the plates.";
}
