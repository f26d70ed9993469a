//! Which steps at the end of a scene take its loads off again.

use super::{PlaneMotion, PlaneTurn, Scene};

/// The share of a load that may be left where it counts as taken off: a part that is unloaded is often held by a little
/// force, so that it stays where it is.
pub const UNLOADED_SHARE: f64 = 0.05;

/// The factor of one load or prescribed motion at the end of every step.
struct Course<'s> {
    name: &'s str,
    forces: bool,
    factors: Vec<f64>,
}

impl Course<'_> {
    /// Does it go towards zero, or stay, in step `step`? Beyond zero a little is none.
    fn falls(&self, step: usize) -> bool {
        let (was, is) = (self.factors[step - 1], self.factors[step]);
        is.abs() <= UNLOADED_SHARE * was.abs() || (is * was >= 0.0 && is.abs() <= was.abs())
    }

    /// Is next to nothing of what it is in step `loaded` left in the end?
    fn is_off(&self, loaded: usize) -> bool {
        let last = self.factors.last().copied().unwrap_or_default();
        last.abs() <= UNLOADED_SHARE * self.factors[loaded].abs()
    }

    fn stays(&self, step: usize) -> bool {
        self.factors[step - 1] == self.factors[step]
    }
}

impl Scene {
    /// The last step before those at the end that only unload: in none of them does a load or a
    /// prescribed motion grow, and in the end every force is down to [`UNLOADED_SHARE`] of what it was. What
    /// motions that go back leave is not known before they have: nothing is asked of it here. `None`
    /// where the scene ends under load.
    pub fn before_unloading(&self) -> Option<usize> {
        let courses = self.courses();
        let last = self.steps.len().checked_sub(1)?;
        let all = |holds: &dyn Fn(&Course) -> bool| courses.iter().all(holds);
        let mut loaded = last;
        while loaded > 0 && all(&|course| course.falls(loaded)) {
            loaded -= 1;
        }
        // A load that is held before it is taken off.
        while loaded < last && all(&|course| course.stays(loaded + 1)) {
            loaded += 1;
        }
        let off = |course: &Course| !course.forces || course.is_off(loaded);
        (loaded < last && all(&off)).then_some(loaded)
    }

    /// As [`Self::before_unloading`], where what is prescribed says so by itself: forces are taken off, or motions go back all the way.
    /// Of motions that go back a little only the solution tells whether as little presses then.
    pub fn before_certain_unloading(&self) -> Option<usize> {
        let loaded = self.before_unloading()?;
        let courses = self.courses();
        let by_forces = courses.iter().any(|course| course.forces);
        let certain = by_forces || courses.iter().all(|course| course.is_off(loaded));
        certain.then_some(loaded)
    }

    /// Do a step and all that follow take the loads off?
    pub fn unloads(&self, step: usize) -> bool {
        self.before_unloading().is_some_and(|full| step > full)
    }

    /// The step whose end is reported: the last, or the last before unloading.
    pub fn reported_step(&self) -> usize {
        let last = self.steps.len().saturating_sub(1);
        self.before_unloading().unwrap_or(last)
    }

    /// Is something moved at the end of step `step`, rather than under a force?
    pub fn is_moved_in(&self, step: usize) -> bool {
        let mut courses = self.courses().into_iter();
        courses.any(|course| !course.forces && course.factors.get(step).is_some_and(|f| *f != 0.0))
    }

    /// The names of every force and motion that is prescribed and not zero; one may come twice.
    pub fn acting_names(&self) -> Vec<&str> {
        let courses = self.courses().into_iter();
        courses.map(|course| course.name).collect()
    }

    /// Of every force and motion that is prescribed and not zero.
    fn courses(&self) -> Vec<Course<'_>> {
        fn course<'s>(scene: &'s Scene, name: &'s str, forces: bool) -> Course<'s> {
            let steps = scene.steps.iter();
            Course {
                name,
                forces,
                factors: steps.map(|step| step.factor_of(name)).collect(),
            }
        }
        let course = |name, forces| course(self, name, forces);
        let mut courses = Vec::new();
        for plane in &self.rigid_planes {
            let has = |counts: fn(&PlaneMotion) -> bool| plane.motion.iter().any(counts);
            let turned = |counts: fn(&PlaneTurn) -> bool| plane.turn.iter().any(counts);
            if has(|m| matches!(m, PlaneMotion::Driven(force) if *force != 0.0))
                || turned(|t| matches!(t, PlaneTurn::Driven(moment) if *moment != 0.0))
            {
                courses.push(course(&plane.name, true));
            }
            if has(|m| matches!(m, PlaneMotion::Held(travel) if *travel != 0.0))
                || turned(|t| matches!(t, PlaneTurn::Held(angle) if *angle != 0.0))
            {
                courses.push(course(&plane.name, false));
            }
        }
        courses.extend(self.tractions.iter().map(|t| course(&t.name, true)));
        let heated = self.temperatures.iter().map(|t| course(&t.name, false));
        courses.extend(heated);
        let moved = self.supports.iter().filter(|support| {
            let gradient = support.gradient.iter().flatten();
            let mut all = support.components.iter().flatten().chain(gradient);
            all.any(|u| *u != 0.0)
        });
        courses.extend(moved.map(|support| course(&support.name, false)));
        courses
    }
}
