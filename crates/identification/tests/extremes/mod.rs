//! Measurements over the whole range of f64, drawn from bytes, and what every fit owes them: an end within a bounded number of
//! questions, and finite numbers or a typed error. Each function says whether there was a fit.
#![allow(dead_code, reason = "each test and each fuzz target uses its own part")]

use std::cell::Cell;

use terramechanics::{
    ContactParams, Direct, ForceModel, JanosiHanamoto, Method, NormalStressRadius, PeakRule, PressureSinkage, ShearLaw,
    SinkageExponent, Slip, SlipSinkage, SoilParams, Wheel, WheelParams, WongReece,
};
use terramechanics_identification::{
    Column, Estimate, Fit, FitError, FitOptions, FittedColumn, LinearFit, Loss, Observations, PlateCurve, PlatesError, Range,
    RollingSample, RunningStrength, Setup, ShearCurve, ShearError, SinkageSource, Sought, Unknown, fit_line_while,
    fit_plates_while, fit_shear_curves_while, fit_while,
};

/// Numbers out of bytes; zeros where these are used up.
pub(crate) struct Draw<'a>(&'a [u8]);

impl<'a> Draw<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    fn below(&mut self, end: usize) -> usize {
        usize::from(self.byte()) % end
    }

    fn flag(&mut self) -> bool {
        self.below(2) == 1
    }

    fn word(&mut self) -> u64 {
        (0..8).fold(0, |word, _| word << 8 | u64::from(self.byte()))
    }

    /// From 0 to 1.
    fn share(&mut self) -> f64 {
        f64::from(self.byte()) / 255.0
    }

    /// A number that somebody may have measured.
    fn plain(&mut self) -> f64 {
        10_f64.powf(8.0 * self.share() - 4.0)
    }

    /// 0, next to nothing, of any power of two, or plain; never negative.
    fn size(&mut self) -> f64 {
        match self.below(8) {
            0 => 0.0,
            1 => f64::from_bits(self.word() >> 12), // subnormal
            2 | 3 => f64::from_bits((self.word() >> 1) % f64::INFINITY.to_bits()),
            _ => self.plain(),
        }
    }

    fn signed(&mut self) -> f64 {
        let size = self.size();
        if self.flag() { -size } else { size }
    }

    fn positive(&mut self) -> f64 {
        let size = self.size();
        if size > 0.0 { size } else { self.plain() }
    }

    /// Mostly plain, where the model or the fit would refuse most of the rest.
    fn mostly_plain(&mut self) -> f64 {
        if self.below(32) == 0 { self.size() } else { self.plain() }
    }

    /// Mostly within a wheel.
    fn sinkage(&mut self) -> f64 {
        if self.below(32) == 0 { self.size() } else { 10_f64.powf(4.0 * self.share() - 5.0) }
    }

    fn list(&mut self, count: usize, of: fn(&mut Self) -> f64) -> Vec<f64> {
        (0..count).map(|_| of(self)).collect()
    }

    fn slip(&mut self) -> Slip {
        let ratio = if self.below(8) == 0 { self.signed() } else { 2.0 * self.share() - 1.0 };
        Slip::new(ratio.clamp(-1.0, 1.0)).expect("a slip")
    }

    fn column(&mut self, count: usize, of: fn(&mut Self) -> f64, has_deviation: bool) -> Option<Column> {
        let values = self.list(count, of);
        let deviation = has_deviation.then(|| self.list(count, Self::mostly_plain));
        (self.below(16) > 0).then_some(Column { values, deviation })
    }

    fn setup(&mut self) -> Setup {
        let wheel = WheelParams { radius: 0.1 + self.share(), width: self.plain(), lug_height: 0.0, lug_coefficient: 0.5 };
        let exponent = SinkageExponent { base: 0.1 + 2.0 * self.share(), slip_gain: self.share(), skid_gain: None };
        let method = match self.below(8) {
            0 => Method::Quadrature,
            1..4 => Method::LINEARISED,
            _ => Method::EXPLICIT,
        };
        let rule = if self.flag() { PeakRule::Midpoint } else { PeakRule::WongReece(WongReece { c1: self.share(), c2: 0.1 }) };
        let sinkage = match self.below(3) {
            0 => SinkageSource::Measured,
            1 => SinkageSource::Load,
            _ => SinkageSource::Static { static_sinkage: self.sinkage(), law: SlipSinkage::Lyasko },
        };
        Setup {
            wheel: Wheel::new(wheel).expect("a wheel"),
            soil: SoilParams {
                cohesion: self.mostly_plain(),
                friction_angle: 1.5 * self.share(),
                shear: Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: self.mostly_plain() })),
                pressure_sinkage: Some(PressureSinkage::Direct(Direct { k_s: 1e3 * self.mostly_plain(), exponent })),
                ..SoilParams::BARE
            },
            contact: ContactParams { rule, ..ContactParams::MIDPOINT },
            model: ForceModel::at_rim(method),
            sinkage,
        }
    }

    fn observations(&mut self, count: usize) -> Observations {
        let has_deviation = self.below(4) == 0;
        Observations {
            slip: (0..count).map(|_| self.slip()).collect(),
            sinkage: self.column(count, Self::sinkage, has_deviation),
            longitudinal: self.column(count, Self::signed, has_deviation),
            normal: self.column(count, Self::mostly_plain, has_deviation),
            torque: self.column(count, Self::signed, has_deviation),
        }
    }
}

/// A caller that counts the questions and may say no to one of them.
struct Caller {
    asked: Cell<u64>,
    no: Option<u64>,
    most: u64,
}

impl Caller {
    fn drawn(draw: &mut Draw<'_>, most: u64) -> Self {
        let no = (draw.below(4) == 0).then(|| u64::from(draw.byte()));
        Self { asked: Cell::new(0), no, most }
    }

    fn go_on(&self) -> bool {
        let asked = self.asked.get() + 1;
        self.asked.set(asked);
        assert!(asked <= self.most, "asked more than {} times", self.most);
        assert!(self.no.is_none_or(|no| asked <= no + 1), "asked again after a no");
        self.no.is_none_or(|no| asked <= no)
    }

    /// Whether it has said no.
    fn has_ended(&self) -> bool {
        self.no.is_some_and(|no| self.asked.get() > no)
    }
}

fn assert_finite(values: impl IntoIterator<Item = f64>, what: &str) {
    for value in values {
        assert!(value.is_finite(), "{what}: {value}");
    }
}

fn assert_finite_estimates(estimates: &[Estimate]) {
    for estimate in estimates {
        let ends = estimate.interval.into_iter().flatten();
        assert_finite([estimate.value].into_iter().chain(estimate.standard_error).chain(ends), "an estimate");
    }
}

fn assert_finite_columns(columns: &[FittedColumn]) {
    for column in columns {
        assert_finite(column.predicted.iter().copied().chain([column.rmse]), "a column");
    }
}

/// Shear tests.
pub(crate) fn shear(draw: &mut Draw<'_>) -> bool {
    // Some hundred moduli for each of some dozen sums beside each estimate.
    let caller = Caller::drawn(draw, 100_000);
    let curves: Vec<ShearCurve> = (0..2 + draw.below(3))
        .map(|_| {
            let count = 1 + draw.below(5);
            let normal = draw.size();
            ShearCurve { normal, displacement: draw.list(count, Draw::size), shear: draw.list(count, Draw::signed) }
        })
        .collect();
    let found = fit_shear_curves_while(&curves, &|| caller.go_on());
    assert_eq!(caller.has_ended(), found == Err(ShearError::Stopped));
    if let Ok(fit) = &found {
        assert_finite_estimates(&fit.estimates);
        let predicted = fit.predicted.iter().flatten().copied();
        let correlation = fit.correlation.iter().flatten().copied().flatten();
        assert_finite(predicted.chain(correlation).chain([fit.rmse, fit.degrees_of_freedom]), "a shear fit");
    }
    found.is_ok()
}

/// Plates.
pub(crate) fn plates(draw: &mut Draw<'_>) -> bool {
    // A few times for each of sixty steps and each plate.
    let caller = Caller::drawn(draw, 4_000);
    let curves: Vec<PlateCurve> = (0..2 + draw.below(3))
        .map(|_| {
            let count = 1 + draw.below(5);
            let width = draw.mostly_plain();
            PlateCurve { width, sinkage: draw.list(count, Draw::positive), pressure: draw.list(count, Draw::size) }
        })
        .collect();
    let found = fit_plates_while(&curves, &|| caller.go_on());
    assert_eq!(caller.has_ended(), found == Err(PlatesError::Stopped));
    if let Ok(fit) = &found {
        assert_finite_estimates(&fit.estimates);
        for plate in &fit.plates {
            assert_finite(plate.predicted.iter().copied().chain([plate.modulus]).chain(plate.own_exponent), "a plate");
        }
        assert_finite(fit.correlation.iter().flatten().copied().flatten().chain([fit.rmse]), "a plate fit");
    }
    found.is_ok()
}

/// The line through rolling samples, at once and one after the other.
pub(crate) fn line(draw: &mut Draw<'_>) -> bool {
    let caller = Caller::drawn(draw, 100);
    let setup = Setup { sinkage: SinkageSource::Measured, ..draw.setup() };
    let count = 1 + draw.below(6);
    let observations = draw.observations(count);
    let found = fit_line_while(&setup, &observations, &|| caller.go_on());
    assert_eq!(caller.has_ended(), found == Err(FitError::Stopped));
    if let Ok(Some(fit)) = &found {
        assert_finite_line(fit);
    }
    running(draw, &setup);
    found.is_ok_and(|line| line.is_some())
}

fn assert_finite_line(fit: &LinearFit) {
    assert_finite_estimates(&fit.estimates);
    assert_finite_columns(std::slice::from_ref(&fit.torque));
    assert_finite(fit.correlation.into_iter().chain([fit.line.freedom, fit.line.condition_number]), "a line");
    let asked = Cell::new(0_u32);
    let bias = fit.model_bias_while(&|| {
        asked.set(asked.get() + 1);
        true
    });
    // Twice for each of the samples in each of the six steps.
    assert!(asked.get() <= 12 * fit.samples() as u32, "asked {} times", asked.get());
    assert_finite(bias.expect("nobody said no").into_iter().flatten(), "a bias");
    let stopped = fit.model_bias_while(&|| false);
    assert_eq!(stopped, Err(FitError::Stopped));
}

fn running(draw: &mut Draw<'_>, setup: &Setup) {
    let Ok(system) = setup.system() else { return };
    let forgetting = if draw.flag() { 1.0 } else { draw.share() };
    let Some(mut running) = RunningStrength::new(system, NormalStressRadius::Rim, forgetting) else { return };
    for _ in 0..1 + draw.below(8) {
        let sample = RollingSample { slip: draw.slip(), sinkage: draw.sinkage(), load: draw.size(), torque: draw.signed() };
        let before = running.estimate();
        if running.take(&sample).is_err() {
            assert_eq!(running.estimate(), before, "a sample that is refused changes nothing");
        }
        if let Some(found) = running.estimate() {
            assert_finite([found.cohesion, found.tan_friction, found.freedom, found.condition_number], "a running estimate");
            for variance in [found.cohesion_variance, found.tan_friction_variance, found.covariance] {
                assert!(!variance.is_nan(), "{found:?}");
            }
        }
    }
}

/// Any unknowns, by any method.
pub(crate) fn nonlinear(draw: &mut Draw<'_>) -> bool {
    const EVALUATIONS: u64 = 2_000;
    let setup = draw.setup();
    let is_integral = setup.model.method == Method::Quadrature;
    let count = 1 + draw.below(if is_integral { 2 } else { 5 });
    let observations = draw.observations(count);
    let mut unknowns: Vec<Unknown> = Unknown::ALL.into_iter().filter(|unknown| unknown.value(&setup).is_some()).collect();
    let most = 1 + draw.below(if is_integral { 2 } else { 5 });
    while unknowns.len() > most {
        unknowns.remove(draw.below(unknowns.len()));
    }
    let sought: Vec<Sought> = unknowns
        .into_iter()
        .map(|unknown| {
            let usual = Sought::from_setup(unknown, &setup);
            if draw.below(4) > 0 {
                return usual;
            }
            let (one, other) = (draw.signed(), draw.signed());
            Sought { unknown, bounds: Range::new(one.min(other), one.max(other)), start: if draw.flag() { one } else { other } }
        })
        .collect();
    let loss = [Loss::LeastSquares, Loss::Huber, Loss::SoftL1, Loss::Cauchy][draw.below(4)];
    let options = FitOptions { starts: 1 + draw.below(3) as u32, loss, evaluations: EVALUATIONS, until: None };
    // The search is asked at each evaluation at the most; the report has 600 sets of at most eight evaluations beside each estimate.
    let caller = Caller::drawn(draw, EVALUATIONS + (600 * 8 + 100) * (count * most) as u64 + 1_000);
    let found = fit_while(&setup, &observations, &sought, &options, &|| caller.go_on());
    assert_eq!(caller.has_ended(), found == Err(FitError::Stopped));
    if let Ok(fit) = &found {
        assert_finite_fit(fit);
    }
    found.is_ok()
}

fn assert_finite_fit(fit: &Fit) {
    assert_finite_estimates(&fit.estimates);
    assert_finite_columns(&fit.columns);
    let correlation = fit.correlation.iter().flatten().copied().flatten();
    let dead = fit.dead_directions.iter().flatten().map(|(_, share)| *share);
    assert_finite(correlation.chain(dead).chain(fit.sinkage.iter().copied()), "a fit");
    assert_finite([fit.degrees_of_freedom].into_iter().chain(fit.reduced_chi_square), "a fit");
    assert!(!fit.condition_number.is_nan());
}
