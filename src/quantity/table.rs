//! The table: to add a quantity to answers is to add a row.

use super::Part::{Across, Coefficients, Components, Motion, Resultant, Soil};
use super::PointValue::{Asked, Found, OrNone, Sideways, UnderLoad};
use super::Quantity;
use super::SampleValue::{Number, OfLoad, Running, WithTorque, Word};
use super::unit::PRESSURE_PER_POWER;

/// All quantities of an operating point and of a sample, in the order of their columns.
pub(crate) static TABLE: &[Quantity] = &[
    Quantity::new("time_s", "t", "s", "time, as it was sent").of_sample(Number(|row| row.time)),
    Quantity::new("slip", "s", "1", "slip ratio").of_point(Motion, Asked(|slip| slip.ratio())).of_sample(Number(|row| row.slip)),
    Quantity::new("sinkage_m", "z", "m", "sinkage")
        .of_point(Motion, Found(|at| at.point.sinkage))
        .of_sample(Number(|row| row.sinkage)),
    Quantity::new("longitudinal_force_n", "F_x", "N", "longitudinal force, the drawbar pull")
        .of_point(Resultant, Found(|at| at.forces.longitudinal))
        .of_sample(Number(|row| row.longitudinal)),
    Quantity::new("normal_force_n", "F_z", "N", "normal force")
        .of_point(Resultant, Found(|at| at.forces.normal))
        .of_sample(Number(|row| row.normal)),
    Quantity::new("torque_n_m", "T", "N.m", "torque about the axle")
        .of_point(Resultant, Found(|at| at.forces.torque))
        .of_sample(Number(|row| row.torque)),
    Quantity::new("traction_n", "AY", "N", "traction: the shear stress along x")
        .of_point(Components, Found(|at| at.forces.components.traction)),
    Quantity::new("resistance_n", "BX", "N", "resistance: the normal stress against x")
        .of_point(Components, Found(|at| at.forces.components.resistance)),
    Quantity::new("normal_support_n", "AX", "N", "normal support: the normal stress along z")
        .of_point(Components, Found(|at| at.forces.components.normal_support)),
    Quantity::new("shear_support_n", "BY", "N", "shear support: the shear stress along z")
        .of_point(Components, Found(|at| at.forces.components.shear_support)),
    Quantity::new("drawbar_coefficient", "F_x/F_z", "1", "drawbar coefficient; null where F_z is not positive")
        .of_point(Coefficients, OrNone(|at| at.forces.drawbar_coefficient()))
        .of_sample(Number(|row| row.drawbar_coefficient)),
    Quantity::new(
        "tractive_efficiency",
        "F_x v/(T ω)",
        "1",
        "tractive efficiency, the power at the axle over that of the torque; null unless the wheel drives, and at rest. Negative \
         where a driven wheel still has to be pulled; there it has no lower bound",
    )
    .of_point(Coefficients, OrNone(|at| at.tractive_efficiency()))
    .of_sample(Number(|row| row.tractive_efficiency)),
    Quantity::new("lateral_force_n", "F_y", "N", "lateral force to the left, with the sign of the slip angle")
        .of_point(Across, Sideways(|side| side.lateral)),
    Quantity::new("overturning_moment_n_m", "M_x", "N.m", "overturning moment r F_y about the forward axis")
        .of_point(Across, Sideways(|side| side.overturning_moment)),
    Quantity::new("aligning_moment_n_m", "M_z", "N.m", "aligning moment of the lateral stresses about the vertical axis")
        .of_point(Across, Sideways(|side| side.aligning_moment)),
    Quantity::new(
        "sinkage_modulus",
        "K_s",
        PRESSURE_PER_POWER,
        "sinkage modulus: the soil's, or the one that a known load shows; null where it cancels and the soil has no exponent, and by the method resistive_force",
    )
    .of_point(Soil, UnderLoad(|at| at.point.sinkage_modulus()))
    .of_sample(OfLoad(|row| row.sinkage_modulus)),
    Quantity::new(
        "sinkage_exponent",
        "N",
        "1",
        "sinkage exponent at this slip; null where the soil has none, and by the method resistive_force",
    )
    .of_point(Soil, OrNone(|at| at.point.sinkage_exponent())),
    Quantity::new(
        "granular_stiffness_n_m3",
        "ξ",
        "N/m3",
        "granular stiffness: the soil's, or the one that a known load shows; null but by the method resistive_force",
    )
    .of_point(Soil, UnderLoad(|at| at.point.granular_stiffness))
    .of_sample(OfLoad(|row| row.granular_stiffness)),
    Quantity::new("shearing_radius_m", "r_s", "m", "shearing radius").of_point(Soil, Found(|at| at.wheel.shearing_radius())),
    Quantity::new("power_w", "T ω", "W", "mechanical power; null where only the slip is known")
        .of_sample(Number(|row| row.power)),
    Quantity::new(
        "energy_j",
        "E",
        "J",
        "energy since the first sample, by the trapezoidal rule from one good sample to the next",
    )
    .of_sample(Number(|row| row.energy)),
    Quantity::new(
        "status",
        "",
        "",
        "ok; static: at rest, with the numbers of the rolling limit; or why there is no result: missing_value, unreadable, \
         out_of_range, slip_out_of_range, opposite_rotation, time_backwards, no_solution.",
    )
    .of_sample(Word(|row| row.status.code())),
    Quantity::new(
        "longitudinal_force_coupled_n",
        "F_x",
        "N",
        "longitudinal force by Ding's coupled form from the measured torque and the load; null where one of them is missing; a \
         warning says so, `status` does not",
    )
    .of_sample(WithTorque(|row| row.longitudinal_coupled)),
    Quantity::new("cohesion_pa", "c", "Pa", "cohesion, by the line through the samples so far; null until two of them differ")
        .of_sample(Running(|strength| strength.cohesion)),
    Quantity::new("tan_friction", "tan φ", "1", "tangent of the friction angle, null where the cohesion is")
        .of_sample(Running(|strength| strength.tan_friction)),
    Quantity::new(
        "cohesion_variance_pa2",
        "var c",
        "Pa2",
        "variance of the cohesion from noise in the samples; null with fewer than three, and while c is held at 0",
    )
    .of_sample(Running(super::sample::cohesion_variance)),
    Quantity::new(
        "tan_friction_variance",
        "var tan φ",
        "1",
        "variance of tan φ from noise in the samples; null with fewer than three, and while tan φ is held at 0",
    )
    .of_sample(Running(super::sample::tan_friction_variance)),
    Quantity::new(
        "cohesion_tan_friction_covariance_pa",
        "cov(c, tan φ)",
        "Pa",
        "covariance of both; null with fewer than three samples, and while one of them is held at 0",
    )
    .of_sample(Running(super::sample::covariance)),
];

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::super::unit::of_name;
    use super::TABLE;

    #[test]
    fn names_are_distinct_and_their_suffixes_are_their_units() {
        let names: BTreeSet<&str> = TABLE.iter().map(|quantity| quantity.about.name).collect();
        assert_eq!(names.len(), TABLE.len());
        let mut suffixes = 0;
        for quantity in TABLE {
            let about = quantity.about;
            assert!(!about.meaning.is_empty() && (quantity.point.is_some() || quantity.sample.is_some()), "{}", about.name);
            if let Some(unit) = of_name(about.name) {
                assert_eq!(about.unit, unit, "{}", about.name);
                suffixes += 1;
            }
        }
        assert!(suffixes > 15, "{suffixes}");
    }
}
