package fieldcal.fit;

import fieldcal.ball.Parameter;
import fieldcal.fit.joint.KickTerm;
import fieldcal.fit.joint.RandomEffect;
import fieldcal.fit.joint.SharedModel;
import fieldcal.fit.joint.SharedProblem;
import fieldcal.fit.joint.SharedProblem.Prior;
import fieldcal.fit.joint.SharedSolution;
import fieldcal.fit.joint.SharedSolution.StopReason;
import fieldcal.fit.joint.SharedSolver;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;

/**
 * Fits all kicks at once: one model, one offset per camera, and position, velocity and time of each kick.
 *
 * <p>Uses what partial kicks determine, each observation with its weight. The parameters of the model are random effects: each kick has its own values, scattered normally about the model's, by an amount that is estimated, too. Where nothing
 * scatters that is one model for all; where carpet, bounces or a wrong law make kicks differ by more than the noise, no kick counts for more than its share, however low the noise is. Where a kick's fit says that its bounces may differ from each other ({@link KickFit#withUnevenBounces}), these differences are parameters of the kick. The closed forms are brought to the kernel of {@link
 * fieldcal.fit.joint}, which also says what the standard errors assume; outliers are judged again after each solution. Immutable and thread-safe.
 */
public final class JointFitter {
  /** Largest number of rounds within which outliers settle. */
  private static final int OUTLIER_ROUNDS = 3;

  private static final SharedSolver SOLVER = SharedSolver.withDefaults().settlingVariants();

  /** Tolerance of a rough fit: a step that gains less than a unit of chi-square moves no offset by its error. */
  private static final double ROUGH = 1;

  /** Most steps of a rough fit. Chosen: of three mixtures in which one model is off by many times the noise, offsets after 12 and after 40 steps differ by less than a tenth of their error. */
  private static final int ROUGH_STEPS = 12;

  /** Standard deviation of the weak prior of the model's parameters, in scales; it keeps a parameter that no kick determines where it is. */
  private static final double EXPECTED = 1000;

  /** Fewer kicks do not determine a scatter: its error would be more than a third of it. */
  private static final int FEWEST_FOR_SCATTER = 6;

  /** How often errors alone may look like a scatter. Chosen: small, since a needless scatter only makes errors larger. */
  private static final double SCATTER_BY_CHANCE = 0.01;

  /** Range in which a scatter is looked for, in scales of the parameter: a smaller one is taken as zero, and with a larger one the parameter has no meaning. */
  private static final double SMALLEST_SCATTER = 1e-3;

  private static final double LARGEST_SCATTER = 5;

  /** Halvings of an interval, until nothing is left of it. */
  private static final int HALVINGS = 40;

  /** Weights that change by less are settled; they describe how much the residuals exceed the cameras' noise. */
  private static final double WEIGHTS_SETTLED = 0.1;

  /** Scale of an offset, m: what cameras of the league disagree by once the first estimate was taken out. */
  private static final double OFFSET_SCALE = 0.01;

  /** A parameter whose error is more than this share of its scale is not determined. */
  private static final double DETERMINED = 0.5;

  private final FitSettings settings;

  /**
   * A fitter; one is enough for all threads.
   *
   * @param settings loss and outlier limits, in standard deviations
   */
  public JointFitter(FitSettings settings) {
    this.settings = Objects.requireNonNull(settings, "settings");
  }

  /**
   * Fits until nothing changes any more.
   *
   * @param problem at least one fitted kick
   * @return the joint model, with standard errors that cover the scatter from kick to kick; {@link JointFit#converged} says whether the solver settled
   * @throws IllegalArgumentException when there is no fitted kick
   */
  public JointFit fit(JointProblem problem) {
    return fitRoughly(problem).refined();
  }

  /**
   * Fits as {@link #fit} does, for the flat model alone: nothing is compared with one model for all kicks.
   *
   * @param problem at least one fitted kick
   * @return the flat model's parameters; empty without flat kicks
   * @throws IllegalArgumentException when there is no fitted kick
   */
  public List<Estimate> flatModel(JointProblem problem) {
    Rough rough = fitRoughly(problem);
    SharedSolution<double[]> solution = rough.run.settled(rough.stage).solution();
    return rough.run.flat(solution, solution.covariance());
  }

  /**
   * Fits roughly, for offsets with which all kicks are then fitted again: outliers are those of the kicks' own fits.
   *
   * @param problem at least one fitted kick
   * @return the offsets, and the way on from there
   * @throws IllegalArgumentException when there is no fitted kick
   */
  public Rough fitRoughly(JointProblem problem) {
    SharedSolver roughly = SOLVER.withTolerance(ROUGH).withMaxIterations(ROUGH_STEPS);
    Run run = new Run(problem, true);
    return new Rough(run, run.begun(roughly));
  }

  /** A rough joint fit. Immutable and thread-safe. */
  public static final class Rough {
    private final Run run;
    private final Stage stage;

    private Rough(Run run, Stage stage) {
      this.run = run;
      this.stage = stage;
    }

    /**
     * What the cameras add to every position.
     *
     * @return by number of the camera
     */
    public Map<Integer, JointFit.Offset> offsets() {
      return run.offsets(stage.solution.state(), stage.solution.covariance());
    }

    /**
     * Goes on until nothing changes any more.
     *
     * @return the joint model of the same kicks, as of {@link JointFitter#fit}
     */
    public JointFit refined() {
      return run.result(run.settled(stage));
    }
  }

  /**
   * Where a fit stands.
   *
   * @param weights of the kicks
   * @param steps taken so far
   */
  private record Stage(SharedSolution<double[]> solution, double[] weights, int steps) {}

  /** One joint fit. Immutable and thread-safe. */
  private final class Run {
    private final JointProblem problem;
    private final int[] cameraIds;
    private final CameraContrasts contrasts;
    private final List<Parameter> globals;
    private final int[] scattering;
    private final List<RandomEffect> randoms = new ArrayList<>();

    Run(JointProblem problem, boolean scatters) {
      if (problem.fits().isEmpty()) {
        throw new IllegalArgumentException("a joint fit needs at least one kick");
      }
      this.problem = problem;
      cameraIds =
          problem.fits().stream()
              .flatMapToInt(f -> Arrays.stream(f.kick().observations().cameras()))
              .distinct()
              .sorted()
              .toArray();
      List<int[]> together =
          problem.fits().stream()
              .map(f -> Arrays.stream(f.kick().observations().cameras()).map(this::slot).toArray())
              .toList();
      contrasts = CameraContrasts.of(cameraIds.length, together);
      globals = globals();
      scattering =
          IntStream.range(0, FlightTerm.OFFSETS)
              .filter(k -> scatters && globals.get(k).estimated() && scatter(k) > 0)
              .toArray();
      for (int k : scattering) {
        double scale = globals.get(k).scale();
        double least = SMALLEST_SCATTER * scale;
        double most = LARGEST_SCATTER * scale;
        double start = Math.max(least, Math.min(most, scatter(k)));
        randoms.add(new RandomEffect(k, start, least, most));
      }
    }

    /**
     * A first estimate of a parameter's scatter, from what the kicks' own fits differ by beyond their errors (Paule and Mandel 1982): the scatter at which the sum of weighted squares about the weighted mean equals its expectation; 0
     * when their errors alone explain it (Cochran's test), or too few kicks determine the parameter.
     */
    private double scatter(int parameter) {
      List<Estimate> known = known(parameter);
      if (known.size() < FEWEST_FOR_SCATTER) {
        return 0;
      }
      double byChance =
          new ChiSquaredDistribution(null, known.size() - 1.0)
              .inverseCumulativeProbability(1 - SCATTER_BY_CHANCE);
      if (squares(known, 0) <= byChance) {
        return 0;
      }
      double low = 0;
      double high = LARGEST_SCATTER * globals.get(parameter).scale();
      for (int i = 0; i < HALVINGS; i++) {
        double middle = 0.5 * (low + high);
        if (squares(known, middle) > known.size() - 1) {
          low = middle;
        } else {
          high = middle;
        }
      }
      return high;
    }

    /** The estimates of a parameter from those single kicks that determine it. */
    private List<Estimate> known(int parameter) {
      boolean flat = parameter < FlightTerm.CHIP;
      int k = flat ? parameter : parameter - FlightTerm.CHIP;
      return problem.fits().stream()
          .filter(f -> (f.kind() == KickKind.FLAT) == flat)
          .map(f -> f.modelEstimates().get(k))
          .filter(Estimate::usable)
          .toList();
    }

    /** Factor by which an error grows because few kicks have shown the scatter, see {@link Estimate#student}. */
    private double student(int parameter) {
      return randomOf(parameter) >= 0 ? Estimate.student(known(parameter).size()) : 1;
    }

    /** Which random effect scatters a parameter; −1 for none. */
    private int randomOf(int parameter) {
      return Arrays.binarySearch(scattering, parameter);
    }

    /** Where the kicks form two groups, the mean of a normal scatter lies between them, where no kick is. */
    private RobustCentre centre(SharedSolution<double[]> solution, int parameter, double error) {
      double scatter = solution.scatters()[randomOf(parameter)];
      List<Estimate> known = known(parameter);
      double[] values = known.stream().mapToDouble(Estimate::value).toArray();
      double[] errors = known.stream().mapToDouble(Estimate::standardError).toArray();
      return RobustCentre.of(
          values,
          errors,
          scatter,
          solution.globals().get(parameter).value(),
          error,
          Agreement.of(values, errors));
    }

    private static double squares(List<Estimate> known, double scatter) {
      double weights = 0;
      double mean = 0;
      for (Estimate e : known) {
        double weight = 1 / (e.standardError() * e.standardError() + scatter * scatter);
        weights += weight;
        mean += weight * e.value();
      }
      mean /= weights;
      double squares = 0;
      for (Estimate e : known) {
        double d = e.value() - mean;
        squares += d * d / (e.standardError() * e.standardError() + scatter * scatter);
      }
      return squares;
    }

    private int slot(int camera) {
      return Arrays.binarySearch(cameraIds, camera);
    }

    private boolean has(KickKind kind) {
      return problem.fits().stream().anyMatch(f -> f.kind() == kind);
    }

    private List<Parameter> globals() {
      List<Parameter> all = new ArrayList<>();
      for (Parameter p : problem.flat().parameters()) {
        all.add(has(KickKind.FLAT) ? p.withValue(p.clamp(p.value())) : p.fixed());
      }
      for (Parameter p : problem.chip().parameters()) {
        boolean given = p.name().equals("accRoll") && problem.chipRoll().isPresent();
        Parameter start =
            given
                ? p.withValue(problem.chipRoll().getAsDouble()).fixed()
                : p.withValue(p.clamp(p.value()));
        all.add(has(KickKind.CHIP) ? start : start.fixed());
      }
      for (int k = 0; k < contrasts.size(); k++) {
        for (String axis : new String[] {"x", "y"}) {
          String name = "contrast " + axis + " " + (k + 1) + " of the cameras' offsets";
          Parameter p = new Parameter(name, "m", 0, OFFSET_SCALE, -1, 1, true, "starts at none");
          all.add(problem.offsets() ? p : p.fixed());
        }
      }
      return all;
    }

    private List<Prior> priors() {
      List<Prior> priors = new ArrayList<>();
      for (int k = 0; k < globals.size(); k++) {
        Parameter p = globals.get(k);
        double deviation = EXPECTED * p.scale();
        priors.add(
            k < FlightTerm.OFFSETS
                ? new Prior(p.value(), 1 / (deviation * deviation))
                : Prior.NONE);
      }
      return priors;
    }

    /** The state that {@link FlightTerm} predicts with. */
    private double[] state(double[] values) {
      double[] state = Arrays.copyOf(values, FlightTerm.OFFSETS + 2 * cameraIds.length);
      for (int c = 0; c < cameraIds.length; c++) {
        for (int axis = 0; axis < 2; axis++) {
          state[FlightTerm.OFFSETS + 2 * c + axis] =
              contrasts.offset(values, FlightTerm.OFFSETS, c, axis);
        }
      }
      return state;
    }

    private FlightTerm term(KickFit fit) {
      Observations seen = fit.kick().observations();
      int[] slot = IntStream.range(0, seen.size()).map(i -> slot(seen.camera(i))).toArray();
      return FlightTerm.of(fit, FlightData.of(seen, problem.cameras()), slot, globals, scattering);
    }

    private SharedSolution<double[]> solve(
        SharedSolver solver,
        List<FlightTerm> kicks,
        List<double[]> starts,
        double[] values,
        List<RandomEffect> randoms,
        double[] weights) {
      List<Parameter> at =
          IntStream.range(0, values.length)
              .mapToObj(k -> globals.get(k).withValue(values[k]))
              .toList();
      SharedModel<double[]> model = this::state;
      return solver.solve(
          new SharedProblem<>(model, kicks, starts, at, priors(), randoms, weights));
    }

    /** From the kicks' own fits, with the outliers of these. */
    Stage begun(SharedSolver solver) {
      List<FlightTerm> kicks = problem.fits().stream().map(this::term).toList();
      double[] weights = problem.fits().stream().mapToDouble(Run::weight).toArray();
      SharedSolution<double[]> solution =
          solve(
              solver,
              kicks,
              kicks.stream().map(FlightTerm::start).toList(),
              globals.stream().mapToDouble(Parameter::value).toArray(),
              randoms,
              weights);
      return new Stage(solution, weights, solution.iterations());
    }

    /** Solved with outliers and weights that follow from the solution before, until they stay as they are. */
    Stage settled(Stage begun) {
      Stage at = begun;
      for (int round = 0; round < OUTLIER_ROUNDS; round++) {
        SharedSolution<double[]> before = at.solution;
        List<FlightTerm> screened = screened(before);
        double[] weights = weights(before);
        if (round > 0 && screened.equals(kicks(before)) && near(at.weights, weights)) {
          break;
        }
        double[] scatters = before.scatters();
        List<RandomEffect> known =
            IntStream.range(0, scatters.length)
                .mapToObj(r -> randoms.get(r).withScatter(scatters[r]))
                .toList();
        SharedSolution<double[]> next =
            solve(SOLVER, screened, before.own(), before.values(), known, weights);
        at = new Stage(next, weights, at.steps + next.iterations());
      }
      return at;
    }

    /** The same with one model for all kicks. What the kicks' own fits keep is no outlier here: it would hide what the model misses. */
    private JointFit.OneModel oneModel(SharedSolution<double[]> solution) {
      boolean even = problem.fits().stream().allMatch(f -> f.bounces().size() == 0);
      if (scattering.length > 0 || !even) {
        Run alike = new Run(problem.withEvenBounces(), false);
        return alike.oneModel(alike.begun(SOLVER).solution);
      }
      return new JointFit.OneModel(Residuals.of(solution).rmsMm(), solution.reducedChiSquare());
    }

    private List<FlightTerm> screened(SharedSolution<double[]> solution) {
      List<FlightTerm> before = kicks(solution);
      double[] state = solution.state();
      return IntStream.range(0, before.size())
          .mapToObj(k -> before.get(k).screened(solution.own(k), state, settings.outlierDistance()))
          .toList();
    }

    /** The weight of a kick, smaller the less its own fit explains it: the residuals of a kick that curves, for example, are systematic and would pull the joint fit to one side. */
    private static double weight(KickFit fit) {
      return 1 / Math.max(1, fit.statistics().varianceFactor());
    }

    /** The weights of flat kicks and of chips: the remaining misfit of one model for all kicks is taken for noise, by the reduced chi-square of each kind. */
    private double[] weights(SharedSolution<double[]> solution) {
      List<FlightTerm> kicks = kicks(solution);
      double[] squares = new double[2];
      double[] degrees = new double[2];
      for (int k = 0; k < kicks.size(); k++) {
        int kind = kicks.get(k).kind().ordinal();
        squares[kind] += weight(problem.fits().get(k)) * solution.chiSquare(k);
        degrees[kind] += kicks.get(k).rows() - kicks.get(k).ownSize();
      }
      return IntStream.range(0, kicks.size())
          .mapToDouble(
              k -> {
                int kind = kicks.get(k).kind().ordinal();
                double rest = Math.max(1, squares[kind] / Math.max(1, degrees[kind]));
                return weight(problem.fits().get(k)) / rest;
              })
          .toArray();
    }

    private static boolean near(double[] a, double[] b) {
      return IntStream.range(0, a.length)
          .allMatch(k -> Math.abs(a[k] - b[k]) <= WEIGHTS_SETTLED * a[k]);
    }

    private static List<FlightTerm> kicks(SharedSolution<double[]> solution) {
      List<FlightTerm> kicks = new ArrayList<>();
      for (KickTerm<double[]> kick : solution.kicks()) {
        kicks.add((FlightTerm) kick);
      }
      return kicks;
    }

    private JointFit result(Stage stage) {
      SharedSolution<double[]> solution = stage.solution;
      Residuals residuals = Residuals.of(solution);
      int observations = kicks(solution).stream().mapToInt(FlightTerm::observations).sum();
      Optional<double[][]> covariance = solution.covariance();
      return new JointFit(
          flat(solution, covariance),
          has(KickKind.CHIP)
              ? estimates(solution, covariance, FlightTerm.CHIP, FlightTerm.OFFSETS)
              : List.of(),
          offsets(solution.state(), covariance),
          residuals.rmsMm(),
          residuals.rmsMm(KickKind.FLAT),
          residuals.rmsMm(KickKind.CHIP),
          residuals.used(),
          observations - residuals.used(),
          solution.reducedChiSquare(),
          oneModel(solution),
          stage.steps,
          solution.stopReason() == StopReason.CONVERGED);
    }

    private List<Estimate> flat(
        SharedSolution<double[]> solution, Optional<double[][]> covariance) {
      return has(KickKind.FLAT) ? estimates(solution, covariance, 0, FlightTerm.CHIP) : List.of();
    }

    private List<Estimate> estimates(
        SharedSolution<double[]> solution, Optional<double[][]> covariance, int from, int to) {
      List<Estimate> list = new ArrayList<>();
      for (Parameter p : solution.globals().subList(from, to)) {
        int k = from + list.size();
        double error =
            p.estimated() && covariance.isPresent()
                ? student(k) * Math.sqrt(covariance.get()[k][k])
                : Double.NaN;
        boolean unknown = p.estimated() && !(error < DETERMINED * p.scale());
        if (randomOf(k) >= 0) {
          RobustCentre centre = centre(solution, k, error);
          p = p.withValue(centre.value());
          error = centre.standardError();
        }
        boolean bound = p.estimated() && (p.value() <= p.min() || p.value() >= p.max());
        Optional<String> reason = unknown ? Optional.of("no kick determines it") : Optional.empty();
        list.add(new Estimate(p, error, reason, bound));
      }
      return list;
    }

    private Map<Integer, JointFit.Offset> offsets(double[] state, Optional<double[][]> covariance) {
      Map<Integer, JointFit.Offset> offsets = new LinkedHashMap<>();
      for (int c = 0; c < cameraIds.length; c++) {
        CameraView view = problem.cameras().get(cameraIds[c]);
        int k = FlightTerm.OFFSETS + 2 * c;
        offsets.put(
            cameraIds[c],
            new JointFit.Offset(
                view.offsetX() + state[k],
                view.offsetY() + state[k + 1],
                offsetError(covariance, c, 0),
                offsetError(covariance, c, 1)));
      }
      return offsets;
    }

    private double offsetError(Optional<double[][]> covariance, int camera, int axis) {
      return problem.offsets() && contrasts.determines(camera) && covariance.isPresent()
          ? contrasts.error(covariance.get(), FlightTerm.OFFSETS, camera, axis)
          : Double.NaN;
    }
  }

  /**
   * What a solution leaves.
   *
   * @param squares sums of squared residuals by kind, m²
   * @param rows their numbers, two of each observation in use
   */
  private record Residuals(double[] squares, int[] rows) {
    static Residuals of(SharedSolution<double[]> solution) {
      double[] squares = new double[KickKind.values().length];
      int[] rows = new int[squares.length];
      List<FlightTerm> kicks = Run.kicks(solution);
      for (int k = 0; k < kicks.size(); k++) {
        FlightTerm kick = kicks.get(k);
        squares[kick.kind().ordinal()] += kick.squaredResiduals(solution.own(k), solution.state());
        rows[kick.kind().ordinal()] += kick.rows();
      }
      return new Residuals(squares, rows);
    }

    double rmsMm() {
      return rms(Arrays.stream(squares).sum(), Arrays.stream(rows).sum());
    }

    double rmsMm(KickKind kind) {
      return rms(squares[kind.ordinal()], rows[kind.ordinal()]);
    }

    int used() {
      return Arrays.stream(rows).sum() / 2;
    }

    private static double rms(double squares, int rows) {
      return rows > 0 ? 1000 * Math.sqrt(squares / rows) : Double.NaN;
    }
  }
}
