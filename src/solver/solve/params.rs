//! The tuning constants of the solution strategy.
//!
//! None of them is a property of the model: they bound effort, decide which of two ways is taken, or say what counts
//! as rounding. Each name says what it bounds; each comment says why it has its value, and on what it was measured.

// --- Increments -------------------------------------------------------------------------------------------------

/// Factor by which an increment grows after one that was not cut back.
pub const INCREMENT_GROWTH: f64 = 1.5;
/// The largest increment over the first one: who asks for a small first increment asks for a fine path.
pub const LARGEST_INCREMENT: f64 = 3.0;
/// Share of a step to which the plastic limit is sought: meshes know it no better.
pub const PLASTIC_LIMIT_KNOWN: f64 = 5e-3;
/// The plastic limit is not sought so closely that more increments than these would be left to the end of the step.
pub const INCREMENTS_TO_LIMIT: f64 = 20.0;
/// Shares of a step that differ by less are the same.
pub const EQUAL_STEP_SHARES: f64 = 1e-6;
/// Share of a load that one increment leaves at least. Contact shrinks with the load: what is solved in one increment
/// from full load to next to none changes beyond recognition.
pub const UNLOADED_LOAD_LEFT: f64 = 1.0 / 3.0;
/// Share of a load at the start of a step below which it counts as gone: thirds of it would never come to an end.
pub const NO_LOAD_LEFT: f64 = 1e-3;
/// Gap over the least one of its pair, as a share of the reach of contact, up to which a row carries in the first
/// guess of a pair that nothing presses yet.
pub const FIRST_TOUCH_REACH: f64 = 0.02;
/// Energy of a correction, over that of the load and all displacements, from which on steel may flow while a load is
/// taken off. On the way to where contact opens it would flow where it does not in the end: an increment of a displaced
/// bearing wandered for 13 iterations, or failed, by the last digit of a correction.
pub const CONTACT_HAS_OPENED: f64 = 1e-6;
/// Growth of the number of closed nodes in the first iteration of an increment from which on contact is found first, with
/// plastic strains as they are. Where nodes close that will not, steel flows beside them as it will not; they open, and what
/// is soft by then comes out between them. The first increment of a displaced bearing of 614 thousand unknowns that flows
/// much (354 nodes closed, 607 in the end) never came to balance;
pub const CONTACT_OUTGROWN: f64 = 1.25;
/// and the energy of a correction, as of [`CONTACT_HAS_OPENED`], at which contact has been found well enough for steel to
/// flow: that increment then takes 15 iterations.
pub const CONTACT_HAS_GROWN: f64 = 1e-4;
/// Iterations that taking a load off may cost: where more are needed, bodies that all but float are left.
pub const UNLOADING_ITERATIONS: usize = 400;
/// A solution of more iterations than these is told with the reason.
pub const UNREMARKABLE_ITERATIONS: usize = 300;
/// Turn over translation of a body's middle above which a body tips or rolls, and does not merely slide.
pub const TIPPING_TURN: f64 = 0.1;

// --- Increments at equal shares of the plastic flow to come -------------------------------------------------------

/// Bounds of the power of the load with which a stress grows: with the root of the load below a line of contact, from
/// nothing beside it.
pub const STRESS_POWERS: [f64; 2] = [0.5, 4.0];
/// Share of the flow of a step that may be taken at once without loss.
pub const NEGLIGIBLE_FLOW: f64 = 0.01;
/// Of the plastic strain, what may have the direction of the end of an increment and not of its course, in steps after the first. (Of
/// six cubes and eight tubes that yield, and again under other loads, travels were 0.1 to 34 % off beside bars of nothing; with it, and
/// once more with what their flow lacks, by 0.001 to 5e-2 % of increments of a thousandth, one cube by 8. With 1e-2 runs take 13 % less time, and 120 blocks and bars that are
/// heated, pressed and cooled are twice as far off.)
pub const TURNED_FLOW: f64 = 3e-3;
/// Of the same, what is let go: an increment of less is not solved once more.
pub const LITTLE_TURNED: f64 = 1e-5;
/// Share of a step below which an increment is not divided for that.
pub const LEAST_TURN: f64 = 1.0 / 128.0;
/// The most increments that a step is planned in.
pub const FLOW_PARTS: usize = 64;
/// Logarithm of the load still to come over the load now below which the power of the stress cannot be told.
pub const STEP_END_LOG: f64 = 1e-6;

// --- Working-set prediction ---------------------------------------------------------------------------------------

/// Share of the flow stress from which an element counts as about to flow.
pub const EARLY_YIELD_SHARE: f64 = 0.85;
/// Power of the load with which the largest stress grows. Below a contact it is 0.5, in bending 1, and where steel
/// flows neighbours take over some. Elements too many cost less than condensing again.
pub const STRESS_GROWTH_POWER: f64 = 0.75;
/// By how much the share of yield from which elements flow falls with the excess of the elastic peak over yield.
/// Bearings with 1.2 to 2.7 times the yield stress: none or two elements of 100 to 2700 flow beyond those foreseen,
/// which are up to twice as many.
pub const STRESS_TAKEN_OVER: f64 = 0.45;
/// The least share of yield in the elastic solution from which an element is taken to flow.
pub const LEAST_FLOW_SHARE: f64 = 0.6;

/// Initial gap up to which contact is integrated, over that at which surfaces were found to overlap.
pub const REACH_MARGIN: f64 = 2.0;
/// Initial gap up to which contact may close, over that at which it was found to close,
pub const CLOSING_MARGIN: f64 = 1.5;
/// and its least growth.
pub const CLOSING_GROWTH: f64 = 2.0;
/// Initial gap up to which contact may close where steel flows, over that at which it closes if none does: strips that
/// become twice as wide. A displaced bearing with p0 of 3.3 times yield needs 2.8.
pub const CONTACT_OF_FLOW: f64 = 4.0;
/// Initial gap up to which contact is integrated before anything is known, as a share of the model: a little more than
/// bodies approach each other in small-strain contact;
pub const FIRST_REACH: f64 = 1e-3;
/// the same, over the least gap, up to which it is likely to close. Half of it takes up to a third longer on bearings near
/// yield, which are prepared once more then; twice of it no less.
pub const FIRST_LIKELY_GAP: f64 = 2e-4;
/// Both over the largest displacement that is prescribed.
pub const REACH_OVER_TRAVEL: f64 = 2.0;

/// Of the size of the scene, an initial gap that is none but for rounding.
pub const ROUNDED_GAP: f64 = 1e-9;

// --- Newton's method ----------------------------------------------------------------------------------------------

/// Of the forces with which contact presses, what counts as load where the load is less: with a residual of 1e-8 balance is then
/// asked for to eleven digits of these forces, as many as soft and hard bodies together leave of sixteen.
pub const PRESSED_DIGITS: f64 = 1e-3;
/// Of the forces with which bodies that are moved as a whole would resist where they were, what counts as load where prescribed forces are less: a
/// residual of 1e-8 of it is fifteen digits of them, all that there are.
pub const MOVED_DIGITS: f64 = 1e-7;

/// Iterations after which stick and slip that have not settled are solved with caution.
pub const ITERATIONS_BEFORE_CAUTION: usize = 25;
/// Iterations of an increment in which nodes may switch between stick and slip as often as they like.
pub const FREE_SWITCHING_ITERATIONS: usize = 12;
/// Switches of one node between stick and slip after which it becomes cautious, late in an increment.
pub const FREE_SWITCHES: u8 = 2;
/// Residual, over that with which the shears of cautious nodes were taken as multipliers last, at which they are taken
/// anew.
pub const CAUTIOUS_SHEAR_RESIDUAL: f64 = 1e-4;
/// Iterations over the limit of the user that an increment may take where corrections become smaller steadily.
pub const CONVERGING_ITERATIONS_FACTOR: usize = 2;
/// Share of the contact violation that an iteration may leave before a penalty softer than the automatic one is raised
/// (Bertsekas, *Constrained Optimization and Lagrange Multiplier Methods*, 1982, section 2.2).
pub const LINGERING_VIOLATION: f64 = 0.25;
/// Share of the largest nodal contact force below which a friction bound or a shear counts as unchanged.
pub const UNCHANGED_FORCE: f64 = 5e-9;
/// The same, of the applied force: rounding leaves a tenth of it in the balance, however little is left to carry.
pub const UNCHANGED_SHARE_OF_LOAD: f64 = 1e-10;
/// Decrease of the residual in an iteration from which on it still falls: near balance Newton's iterations leave a
/// hundredth and less of it, or all that rounding leaves.
pub const STALLED_DECREASE: f64 = 0.5;
/// The most, of the load, that rounding may leave in the balance of an answer. Of columns and layers with moduli up to a
/// million times apart it leaves 1e-8 to 2e-6, a fifth to a tenth of what the sizes of the sums say. With penalties lowered a
/// hundredfold then, some came down to 3e-9, in up to thirty more iterations, and those with 2e-6 hardly.
pub const MOST_ROUNDING: f64 = 1e-5;
/// Iterations for which shears taken as multipliers may raise the residual again before it falls: one wave.
pub const WAVE_ITERATIONS: usize = 8;
/// Residual below which balance is never given up as lost.
pub const LOST_RESIDUAL: f64 = 1e-3;
/// Decrease of the least residual from one wave to the next that still counts as progress.
pub const LOST_DECREASE: f64 = 0.5;
/// Residual that, kept for half a wave, means that there is no balance: what will be in balance is never off by a
/// third of the load for so long.
pub const HOPELESS_RESIDUAL: f64 = 0.3;
/// Decrease of the largest correction from one wave to the next with which iterations go on beyond their limit.
pub const STEADY_DECREASE: f64 = 0.1;
/// Displacement over the size of the model from which a body counts as having left it.
pub const RUNAWAY_EXTENTS: f64 = 10.0;
/// Residual of a correction over that with which the increment would have converged.
pub const CORRECTION_TOLERANCE: f64 = 0.05;
/// The smallest share of its residual that a correction may leave: beyond is rounding.
pub const TIGHTEST_CORRECTION: f64 = 1e-12;
/// The largest. What a factor solves to is exact but for its age;
pub const LOOSEST_CORRECTION: f64 = 1e-4;
/// where steel flows, iterations leave more than this themselves until the last few, and solving closer is lost work: a
/// displaced bearing of 136 thousand unknowns takes 298 iterations instead of 293, and 79 s instead of 94 (1e-2: 324);
pub const FLOWING_CORRECTION: f64 = 1e-3;
/// parts of a divided model that are put together leave what hardly resists.
pub const LOOSEST_DIVIDED_CORRECTION: f64 = 1e-6;
/// Share of all elements that flow from which a failure is one of the plastic limit, and not of a body that is free.
pub const LIMIT_FLOW_SHARE: f64 = 0.02;
/// Residual below which flow is looked for that was not foreseen: an increment that goes on with it from there takes half a
/// dozen iterations less than one that is solved once more from balance.
pub const EARLY_LOOK_RESIDUAL: f64 = 1e-4;
/// Tolerances of the second solution over those of an answer: what it tells are differences of 1e-4 and more.
pub const ROUGH_BALANCE: f64 = 1e2;
/// Slope left by the line search, over that at its start.
pub const LINE_SEARCH_SLOPE: f64 = 0.5;
/// Evaluations that the line search may take.
pub const LINE_SEARCH_TRIES: usize = 8;
/// Steps by which a friction bound may be extrapolated, over the last step.
pub const BOUND_EXTRAPOLATION_ON: f64 = 10.0;
/// Share of the last step by which a friction bound may be held back.
pub const BOUND_EXTRAPOLATION_BACK: f64 = 0.5;

// --- Proximal point method ----------------------------------------------------------------------------------------

/// Stiffness of the springs in each turn, over that of the bodies at the same unknown.
pub const PROXIMAL_STIFFNESSES: [f64; 11] = [
    1e-2, 1e-3, 1e-3, 1e-4, 1e-4, 1e-4, 1e-5, 1e-5, 1e-6, 1e-6, 1e-7,
];
/// Residual at which a turn ends: it is a first guess only.
pub const PROXIMAL_RESIDUAL: f64 = 1e-3;
/// Iterations after which a turn ends in any case.
pub const PROXIMAL_ITERATIONS: usize = 8;

// --- Linear systems -----------------------------------------------------------------------------------------------

/// Share of the diagonal that is added to a matrix *before it is factored*: it keeps the factor of a body that is free
/// for a moment positive definite. The system that is solved does not contain it, so that no force passes through it.
pub const FACTOR_SHIFT: f64 = 1e-10;
/// Integration points that may have begun or ceased to flow since a factor was made for it to be tried again. Without
/// this bound a displaced bearing of 116 thousand unknowns takes 11 factors in place of 30 and next to no less time (124 and
/// 127 s), and the punch of enhanced elements at its limit load (`verify --suite punch`) does not converge.
pub const AGED_FACTOR_FLOW_CHANGES: usize = 48;
/// The same as a share of those that flow, one in so many.
pub const AGED_FACTOR_FLOW_SHARE: usize = 100;
/// Krylov directions with a factor that has not aged, to the precision that is asked for last.
pub const FRESH_FACTOR_DIRECTIONS: usize = 4;
/// Krylov directions with an aged factor: about what a new factor costs (27 of a displaced bearing of 116 thousand unknowns,
/// more of condensed ones).
pub const AGED_FACTOR_DIRECTIONS: usize = 24;
/// Share of its residual that a correction with an aged factor may leave, at any time: beside stiff contact the residual
/// does not show what is missing of soft motions. The centre bearing with 0.01 to 100 times the penalty takes 68 to 82
/// iterations; without this bound up to 240, and increments fail.
pub const AGED_CORRECTION: f64 = 1e-4;
/// Corrections with new factors after an aged one was not good enough: nodes that slip change the matrix though their
/// statuses stay.
pub const AGED_FACTOR_PAUSE: usize = 3;
/// Error of a correction of a large divided model, in the energy norm, that is left to the next iteration.
pub const DIVIDED_CORRECTION_ERROR: f64 = 1e-2;
/// Krylov directions with a fresh factor in single precision; where more are needed double precision takes over.
pub const SINGLE_FACTOR_DIRECTIONS: usize = 8;
/// Krylov directions with a fresh factor.
pub const FACTOR_DIRECTIONS: usize = 150;
/// Multiplications that finding columns of a low-rank update may take, over those of a new factor, which would also be of
/// no age.
pub const NEW_COLUMNS_WORK: f64 = 0.5;
/// Columns of a low-rank update that are kept.
pub const KEPT_COLUMNS: usize = 900;

// --- Static condensation, and what it costs on a machine of two cores ---------------------------------------------
// Measured on bearings of 25 to 220 thousand unknowns, elastic and plastic. Only ratios decide.

/// Multiplications a second of a sparse factor in single precision, with dense blocks of a thousand and more.
pub const SINGLE_FACTOR_RATE: f64 = 4.5e10;
/// The same in double precision, in which bodies are condensed: 2.4 to 2.9e10.
pub const DOUBLE_FACTOR_RATE: f64 = 2.5e10;
/// Seconds per direction and factor entry, all else of an iteration with it; 1.5 to 2.1e-9 in double.
pub const SECONDS_PER_FACTOR_ENTRY: f64 = 1.2e-9;
/// New factors an iteration: the others bring an old one up to date. 0.3 to 0.5 where steel flows.
pub const FACTORS_PER_ITERATION: f64 = 0.4;
/// Krylov directions an iteration.
pub const DIRECTIONS_PER_ITERATION: f64 = 5.0;
/// Seconds per unknown of a divided model: 6.5e-6 to 1.6e-5, in 12 to 30 directions, when its coarse system was affine; 5e-6
/// to 6e-6, in 8 to 15, since, on a machine on which one factor, too, takes a third of what is reckoned. And there are 1.2 to 1.5 times as
/// many iterations as with one factor, which solves to more digits.
pub const SECONDS_PER_DIVIDED_UNKNOWN: f64 = 1.6e-5;
/// Entries of a factor of bodies some of which are condensed, over those of each by itself: of a displaced bearing of 136
/// thousand unknowns.
pub const MIXED_FILL: f64 = 1.25;
/// Iterations before bodies are condensed once more.
pub const ITERATIONS_PER_CONDENSATION: f64 = 15.0;
/// Share of the available memory that one factor may take before the model is divided.
pub const FACTOR_MEMORY_SHARE: f64 = 0.7;
/// Bytes of a model with one factor up to which time alone decides whether it is divided. An elastic displaced bearing of 438
/// thousand unknowns takes 8 GB and 95 s, 4 directions an iteration at most; one of its kind that is divided takes 20.
pub const MODEST_MEMORY: f64 = 1e10;
/// Unknowns up to which a divided model is solved exactly: directions cost next to nothing there.
pub const SMALL_DIVIDED_MODEL: usize = 20_000;
/// Element matrices that are held in memory at once.
pub const ELEMENTS_PER_BATCH: usize = 1024;
/// Iterations of a step where nothing depends on the path, for a forecast.
pub const ITERATIONS_PER_PATH_FREE_STEP: f64 = 5.0;
/// Iterations of an increment where something does, for a forecast.
pub const ITERATIONS_PER_INCREMENT: f64 = 8.0;
/// Processor seconds per unknown and iteration: bearings of 36 thousand to a million unknowns in
/// `docs/performance.md` take 0.9 to 1.6e-5.
pub const SECONDS_PER_UNKNOWN_ITERATION: f64 = 1.4e-5;

// --- Contact ------------------------------------------------------------------------------------------------------

/// Penalty over the stiffness of the material next to the contact, at a user factor of one. The augmented-Lagrange
/// update makes the answer independent of it; it only has to be stiff enough that few updates are needed and soft
/// enough that the factor stays accurate.
pub const CONTACT_PENALTY: f64 = 1000.0;
/// The same where a divided model is large and there is friction, which follows the pressure: corrections are then
/// right to a hundredth of their energy, and beside stiffer contact next to none of that is left for how the pressure
/// is distributed. A displaced bearing of 143 thousand unknowns, divided, takes 164 iterations with 50, 110 with 200, 105 with
/// 400 and 112 with 1000, in 1640, 1410, 1435 and 1620 directions; of 614 thousand its first plastic
/// increment is cut back with 200 and 1000, not with 50, and 200 takes the least time.
pub const DIVIDED_CONTACT_PENALTY: f64 = 200.0;
/// The softest penalty whatever the user's factor: with a softer one multipliers take dozens of updates.
pub const SOFTEST_PENALTY: f64 = 10.0;
/// The stiffest: beyond it rounding of displacements makes forces that never balance.
pub const STIFFEST_PENALTY: f64 = 1e6;
/// Gap over the least one of its pair, as a share of the model, up to which contact touches before any load.
pub const TOUCHING_GAP: f64 = 1e-7;
/// Moves that close the gap of one body: the gap of a curved side is not quite linear in the way.
pub const CLOSING_ROUNDS: usize = 12;
/// Overlap that the mesh explains, over the sagitta and the bend of the facets. In the facet where contact ends one
/// weighted gap balances what opens against what overlaps: 2 to 3 sagittas on lines and spheres with two to five
/// facets across the half-width.
pub const RIM_OVERLAP: f64 = 4.0;
/// Overlap at the last node that presses, over the gap of the next one, that its weighted gap does not tell from closed. Between
/// hat functions on sides of h and H the weights are (h + H) / 3 and H / 6: up to a half where the open side is long.
pub const OPENING_SHARE: f64 = 0.5;

// --- Rigid-body modes and statics ---------------------------------------------------------------------------------

/// Resistance to a motion, over that of a single support, below which it is free of supports and contact. A cylinder
/// that rolls is resisted by the facets that stand for it.
pub const UNRESISTED_EIGENVALUE: f64 = 1e-5;
/// The same from which contact that is likely to close holds what is free at first touch: its nodes lie some 7 % of the model's size
/// apart. A plate on a roller would have them, too, across the strip, and tips all the same.
pub const CLOSING_EIGENVALUE: f64 = 5e-3;
/// The same where supports alone resist: only rounding is left.
pub const MOVABLE_EIGENVALUE: f64 = 1e-9;
/// Share of the load on a free motion above which it is driven, and not merely rounding.
pub const DRIVEN_MODE_LOAD: f64 = 1e-6;
/// Unbalanced force, over the load, at which rigid bodies are at rest.
pub const REST_RESIDUAL: f64 = 1e-6;
/// Pseudo-time steps in which rest is sought.
pub const REST_STEPS: usize = 400;
/// Newton iterations of one such step,
pub const REST_ITERATIONS: usize = 12;
/// and the number up to which it was easy, so that the next one may be ten times larger.
pub const EASY_REST_ITERATIONS: usize = 5;
/// Unbalanced force, over the load, at which a pseudo-time step is solved.
pub const REST_STEP_RESIDUAL: f64 = 1e-9;
/// Edges of the polygon that stands for a circle of friction.
pub const CONE_EDGES: usize = 16;
/// Share of the load that may be left over in a balance: the shapes of facets, and rounding.
pub const BALANCE_REMAINDER: f64 = 1e-5;
/// The largest coefficient of friction that is advised.
pub const ROUGHEST_FRICTION: f64 = 2.0;
/// Angle by which a body may rock towards a node that then bears it, radians.
pub const ROCKING_ANGLE: f64 = 5e-3;
/// Cosine of the angle between two sides of a node above which they do not lie opposite.
pub const OPPOSITE_COSINE: f64 = -0.7;
/// Way of the least gap off a node, over the way to its neighbour, from which the neighbour bears too.
pub const RIDGE_OFFSET: f64 = 0.02;
/// Forces that enter a least-squares problem with non-negative unknowns before it is given up.
pub const NONNEGATIVE_ROUNDS: usize = 1000;
/// Relative rounding in that problem.
pub const NONNEGATIVE_ROUNDING: f64 = 1e-12;

// --- Spring-back --------------------------------------------------------------------------------------------------

/// Error of forces that are the difference of elastic ones, as a share of these.
pub const ELASTIC_FORCE_ROUNDING: f64 = 1e-13;
/// The smallest residual that is sought.
pub const SPRING_BACK_TOLERANCE: f64 = 1e-9;
/// The largest residual that is good enough.
pub const SPRING_BACK_RESIDUAL: f64 = 1e-6;
/// The loosest tolerance: forces that are nothing but rounding are solved for too, and what comes out is as small.
pub const SPRING_BACK_LOOSEST: f64 = 0.1;
