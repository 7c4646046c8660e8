//! What is watched of the load and the torque.

use super::{CautionKind, TestedRange};
use crate::rolling::WheelOnSoil;

/// Residual of the load balance over the load above which a result says so; a thousand times more is refused.
const LARGEST_LOAD_RESIDUAL: f64 = 1e-9;

/// How many times the modulus that a load shows may be the soil's own, or the other way round, before a result says so. At 10 mm under
/// a plate 0.1 m wide the pressures of the catalogue's lunar simulants lie apart by a factor of 5.8, and those of its sands in test
/// beds by 3.2: what is further off is not the soil named, or not this load or sinkage.
const LARGEST_RATIO: f64 = 6.0;

/// Change of the normal force with slip beyond which a result says so; a choice.
const LARGEST_DRIFT: f64 = 0.1;

kinds! {
    LOAD_RESIDUAL = CautionKind {
        code: "load_residual",
        meaning: "The normal force is a small difference of large parts and balances the load only to within this residual.",
        advice: "Trust no more digits of the forces than this residual leaves.",
        parameter: Some(&WheelOnSoil::NORMAL_LOAD),
        range: Some(TestedRange {
            quantity: "normal force minus load, over the load",
            unit: "1",
            lower: None,
            upper: Some(LARGEST_LOAD_RESIDUAL),
            source: "the load balance itself",
        }),
    };
    NEGATIVE_NORMAL_STRESS = CautionKind {
        code: "negative_normal_stress",
        meaning: "With this load and torque the soil would have to pull the wheel down, which it cannot do. The two do not \
                  fit together at this slip and sinkage.",
        advice: "Check the measured torque, load, slip and sinkage.",
        parameter: Some(&WheelOnSoil::TORQUE),
        range: Some(TestedRange {
            quantity: "normal stress at the peak",
            unit: "Pa",
            lower: Some(0.0),
            upper: None,
            source: "letter, Eq. 11, solved for the stresses",
        }),
    };
    NORMAL_FORCE_DRIFTS = CautionKind {
        code: "normal_force_drifts",
        meaning: "The sinkage follows from the slip and the load is not known, so that the normal force drifts away from its value at \
                  the standstill by this share, while the load of a wheel that drives on does not change. On seven public sets of \
                  tests it drifts by 0.6 to 1.8 of the load.",
        advice: "Give the load beside the static sinkage: it then takes the place of the sinkage modulus.",
        parameter: Some(&WheelOnSoil::NORMAL_LOAD),
        range: Some(TestedRange {
            quantity: "relative change of the normal force from the standstill",
            unit: "1",
            lower: Some(-LARGEST_DRIFT),
            upper: Some(LARGEST_DRIFT),
            source: "the model itself at the standstill; the bound is a choice",
        }),
    };
    MODULUS_UNLIKE_SOIL = CautionKind {
        code: "modulus_unlike_soil",
        meaning: "The sinkage modulus that load and sinkage show together is far from that of the soil's own pressure–sinkage law. The \
                  soils of one kind lie apart by less.",
        advice: "Check load, sinkage and soil, and their units. The soil's own modulus has no influence; its strength has.",
        parameter: Some(&WheelOnSoil::NORMAL_LOAD),
        range: Some(TestedRange {
            quantity: "sinkage modulus found over that of the soil",
            unit: "1",
            lower: Some(1.0 / LARGEST_RATIO),
            upper: Some(LARGEST_RATIO),
            source: "the spread of the pressures of lunar simulants in the catalogue, a factor of 5.8; the bound is a choice",
        }),
    };
    TORQUE_AGAINST_SLIP = CautionKind {
        code: "torque_against_slip",
        meaning: "The torque has not the sign that goes with this slip. At this slip the rim moves over the soil in one direction all \
                  along the contact, and the shear stress of that direction gives a torque of the other sign.",
        advice: "Check the signs of torque and slip, and the circle on which the slip is counted.",
        parameter: Some(&WheelOnSoil::TORQUE),
        range: None,
    };
}
