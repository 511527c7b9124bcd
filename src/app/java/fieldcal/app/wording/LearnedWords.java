package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.effect.learned.Harmonics;
import fieldcal.effect.learned.LearnedCurve;
import fieldcal.effect.learned.LearnedCurve.Point;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.learned.Quantity;
import fieldcal.effect.learned.SimpleFormula;
import fieldcal.effect.learned.Variable;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What a learned term says of the field, in an operator's words. */
public final class LearnedWords {
  /** A session's drift is said over this time, s. */
  private static final double SESSION_STEP = 600;

  private static final double MINUTE = 60;

  private static final double PER_CENT = 100;

  private LearnedWords() {}

  /**
   * The name of a term.
   *
   * @param term which
   * @return for example "braking that depends on the speed" or "reports of camera 2 that depend on the place in the image"
   */
  public static String name(LearnedTerm term) {
    String on =
        term.family().variables().stream()
            .map(LearnedWords::variable)
            .collect(Collectors.joining(" and "));
    String who = term.camera().isPresent() ? " of " + CameraName.of(term.camera().getAsInt()) : "";
    return switch (term.family().quantity()) {
      case ACCELERATION_ALONG -> "braking that depends on " + on;
      case ACCELERATION_ACROSS -> "sideways pull that depends on " + on;
      case FRICTION -> "friction that depends on " + on;
      case ROLLING -> "rolling that depends on " + on;
      case SLIDING -> "sliding friction that depends on " + on;
      case PUSH -> "push that depends on " + on;
      case FLOOR -> "height of the floor that depends on " + on;
      case NAP -> "direction of the carpet that depends on " + on;
      case AIR -> "moving air that depends on " + on;
      case VERTICAL_RESTITUTION -> "height of bounces that depends on " + on;
      case TANGENTIAL_RESTITUTION -> "loss of speed at bounces that depends on " + on;
      case TURN -> "turn at bounces that depends on " + on;
      case SPIN -> "spin from the kicker that depends on " + on;
      case SHIFT -> "reports" + who + " that depend on " + on;
      case TIME_ERROR -> "time stamps" + who + " that depend on " + on;
    };
  }

  /**
   * A fitted term. If held-out kicks gain nothing by it, only its name is given: its curve may be the shape of anything else that is left.
   *
   * @param term which
   * @param curves its curves, one of each component
   * @param helps whether kicks that were held out gain by it
   * @param extendedHelps whether the extended model predicts better than the simple one
   * @return its text; the consequence is empty, and so is the advice where nothing can be done
   */
  public static CauseText of(
      LearnedTerm term, List<LearnedCurve> curves, boolean helps, boolean extendedHelps) {
    String told =
        curves.stream()
            .map(c -> sentence(c, SimpleFormula.of(c)))
            .flatMap(Optional::stream)
            .reduce("", LearnedWords::joined);
    String strength =
        curves.stream().map(c -> SimpleFormula.of(c).text()).collect(Collectors.joining(", "));
    String what =
        helps ? told.isEmpty() ? uncertain(term) : told : Sentences.begin(name(term)) + ".";
    return new CauseText(name(term), what, "", advice(term, extendedHelps), strength);
  }

  /**
   * What a curve is drawn over.
   *
   * @param curve of a fitted term
   * @param number 0 = the first number of a point, 1 = the second of a table
   * @return a few words without the unit
   */
  public static String axis(LearnedCurve curve, int number) {
    Variable variable = numbered(curve, number);
    if (variable.dimension() == 2) {
      String below = variable == Variable.IMAGE_POSITION ? " from below the camera" : "";
      return (number == 0 ? "x" : "y") + below;
    }
    return switch (variable) {
      case HEADING -> "direction of travel";
      case HOP -> "bounce";
      case SESSION_TIME -> isInTime(curve) ? "time within a period" : "time of the session";
      default -> noun(variable);
    };
  }

  /**
   * The unit of {@link #axis}: degrees for angles, minutes for the session's time.
   *
   * @param curve of a fitted term
   * @param number 0 or 1
   * @return may be empty
   */
  public static String axisUnit(LearnedCurve curve, int number) {
    return switch (numbered(curve, number)) {
      case HEADING -> "°";
      case SESSION_TIME -> isInTime(curve) ? "s" : "min";
      default -> numbered(curve, number).unit();
    };
  }

  /**
   * A point's number in the {@link #axisUnit}.
   *
   * @param curve of a fitted term
   * @param number 0 or 1
   * @param value as in the point
   * @return the same in the axis' unit
   */
  public static double onAxis(LearnedCurve curve, int number, double value) {
    return switch (numbered(curve, number)) {
      case HEADING -> Math.toDegrees(value);
      case SESSION_TIME -> isInTime(curve) ? value : value / MINUTE;
      default -> value;
    };
  }

  private static Variable numbered(LearnedCurve curve, int number) {
    List<Variable> variables = curve.family().variables();
    return variables.get(Math.min(number, variables.size() - 1));
  }

  /**
   * What a curve shows.
   *
   * @param curve of a fitted term
   * @return for example "acceleration along the path"
   */
  public static String quantity(LearnedCurve curve) {
    return switch (curve.family().quantity()) {
      case ACCELERATION_ALONG -> "acceleration along the path";
      case ACCELERATION_ACROSS -> "acceleration to the left";
      case FRICTION -> "change of the friction";
      case ROLLING -> "change of the rolling deceleration";
      case SLIDING ->
          curve.component() == 0
              ? "change of the sliding friction"
              : "pull to the left of the slip";
      case PUSH -> "acceleration towards " + axis(curve);
      case FLOOR -> "height of the floor";
      case NAP -> "change of the rolling deceleration towards " + axis(curve);
      case AIR -> "velocity of the air towards " + axis(curve);
      case VERTICAL_RESTITUTION -> "change of the vertical damping";
      case TANGENTIAL_RESTITUTION -> "change of the horizontal damping";
      case TURN -> "turn to the left";
      case SPIN -> "spin, share of rolling";
      case SHIFT -> "reported too far along " + (curve.component() == 0 ? "x" : "y");
      case TIME_ERROR -> "stamp too late";
    };
  }

  /**
   * The unit of {@link #inUnit}.
   *
   * @param curve of a fitted term
   * @return degrees for a turn, per cent for friction and rolling; may be empty
   */
  public static String unit(LearnedCurve curve) {
    return switch (curve.family().quantity()) {
      case TURN -> "°";
      case FRICTION, ROLLING, SLIDING, NAP -> "%";
      default -> curve.family().quantity().unit();
    };
  }

  /**
   * A value of a curve in its {@link #unit}.
   *
   * @param curve of a fitted term
   * @param value as in a point
   * @return the same in the unit
   */
  public static double inUnit(LearnedCurve curve, double value) {
    return switch (curve.family().quantity()) {
      case TURN -> Math.toDegrees(value);
      case FRICTION, ROLLING, SLIDING, NAP -> PER_CENT * value;
      default -> value;
    };
  }

  /** Two sentences; what both begin with, up to a colon, is said once. */
  private static String joined(String first, String second) {
    int colon = second.indexOf(": ");
    return colon > 0 && first.startsWith(second.substring(0, colon + 2))
        ? first.substring(0, first.length() - 1) + "; " + second.substring(colon + 2)
        : (first + " " + second).strip();
  }

  /** Where no single value of a curve is certain and all of them together are. */
  private static String uncertain(LearnedTerm term) {
    return Sentences.begin(name(term))
        + ": held-out kicks show that the effect exists, but not its shape; every value of the"
        + " curve is within two standard errors of zero.";
  }

  private static String advice(LearnedTerm term, boolean extendedHelps) {
    if (term.camera().isPresent()) {
      int camera = term.camera().getAsInt();
      String repair =
          term.family().quantity() == Quantity.TIME_ERROR
              ? text("Check the clock of the computer of %s", CameraName.of(camera))
              : text("Calibrate %s in vision again", CameraName.of(camera));
      return repair + (extendedHelps ? "; otherwise use the extended model." : ".");
    }
    boolean unround =
        term.dependsOn().contains(Variable.DISTANCE_ROLLED.label())
            && term.family().basis() instanceof Harmonics;
    if (unround) {
      return "Try another ball"
          + (extendedHelps ? "; with this one, use the extended model." : ".");
    }
    return extendedHelps ? "Use the extended model." : "";
  }

  /**
   * A curve in a sentence.
   *
   * @param curve of a fitted term
   * @param formula its best simple formula
   * @return for example "From 4 m/s on, the sliding ball is braked less than the model says: by 0.30 m/s²."; empty when the curve has no formula, and no value beyond two standard errors
   */
  public static Optional<String> sentence(LearnedCurve curve, SimpleFormula formula) {
    return switch (formula.kind()) {
      case NONE, CURVE ->
          isInTime(curve)
              ? curve.certainlyHighest().map(p -> everyPeriod(curve, p.value()))
              : between(curve, curve.family().variables().get(0));
      default -> Optional.of(simple(curve, formula));
    };
  }

  private static String simple(LearnedCurve curve, SimpleFormula formula) {
    double a = formula.amount();
    Variable variable = curve.family().variables().get(0);
    boolean session = variable == Variable.SESSION_TIME;
    double perStep = session ? a * SESSION_STEP : a;
    String change = change(curve, a);
    String size = size(curve, a);
    String eachSize = size(curve, perStep);
    return switch (formula.kind()) {
      case SLOPE -> text("The %s: by %s for each %s.", change, eachSize, each(variable));
      case QUADRATIC ->
          text(
              "The %s: by %s times the square of the %s in %s.",
              change, size, noun(variable), variable.unit());
      case INVERSE ->
          text(
              "The %s: by %s divided by the %s in %s.",
              change, size, noun(variable), variable.unit());
      case ONSET ->
          text(
              "From %s on, the %s: by %s for each further %s.",
              at(variable, formula.place()), change, eachSize, step(variable));
      case STEP -> text("From %s on, the %s: by %s.", at(variable, formula.place()), change, size);
      case SINE ->
          isInTime(curve) ? everyPeriod(curve, formula.amount()) : sine(curve, formula, variable);
      case GRADIENT ->
          text(
              "The %s, and more so the farther the ball is %s: by %s for each metre.",
              change(curve, 1), FieldWords.direction(formula.place()), size(curve, a));
      case STEP_X -> text("Beyond x = %s m, the %s: by %s.", place(formula), change, size);
      case STEP_Y -> text("Beyond y = %s m, the %s: by %s.", place(formula), change, size);
      case NONE, CURVE -> throw new IllegalArgumentException("no simple formula");
    };
  }

  /** Whether a curve comes again in time. */
  private static boolean isInTime(LearnedCurve curve) {
    return curve.family().isPeriodic()
        && curve.family().variables().contains(Variable.SESSION_TIME);
  }

  private static String everyPeriod(LearnedCurve curve, double amount) {
    double period = ((Harmonics) curve.family().basis()).period();
    return text(
        "Once every %s s, the %s, and then the opposite: by %s.",
        Amount.of(period), change(curve, 1), size(curve, amount));
  }

  private static String place(SimpleFormula formula) {
    return Amount.decimals(formula.place(), 1);
  }

  private static String sine(LearnedCurve curve, SimpleFormula formula, Variable variable) {
    String size = size(curve, formula.amount());
    String change = change(curve, 1);
    if (variable == Variable.DISTANCE_ROLLED) {
      return text(
          "During each turn of the ball, the %s, and then the opposite: by %s.", change, size);
    }
    String direction = FieldWords.direction(formula.place());
    return curve.family().basis() instanceof Harmonics h && h.period() < Math.PI
        ? text(
            "The %s when it goes %s, or every %s° from there: by %s. Halfway between these"
                + " directions, the opposite is true.",
            change, direction, Amount.decimals(Math.toDegrees(h.period()), 0), size)
        : text(
            "The %s when it goes %s: by %s. When it goes the other way, the opposite is true.",
            change, direction, size);
  }

  /** The places where the curve is most certainly on one side and on the other. */
  private static Optional<String> between(LearnedCurve curve, Variable variable) {
    return Stream.of(curve.certainlyLowest(), curve.certainlyHighest())
        .flatMap(Optional::stream)
        .map(
            p ->
                text(
                    "%s the %s by %s",
                    where(variable, p), change(curve, p.value()), size(curve, p.value())))
        .reduce((low, high) -> low + ", and " + high)
        .map(
            places ->
                text("The error of the model depends on %s: %s.", variable(variable), places));
  }

  private static String where(Variable variable, Point p) {
    if (variable.dimension() == 1) {
      return "at " + at(variable, p.x());
    }
    String below = variable == Variable.IMAGE_POSITION ? ", seen from below the camera," : "";
    return text(
        "at x = %s m, y = %s m%s", Amount.decimals(p.x(), 1), Amount.decimals(p.y(), 1), below);
  }

  private static String size(LearnedCurve curve, double amount) {
    Optional<String> ofWhat = shareOf(curve.family().quantity());
    if (ofWhat.isPresent()) {
      return text("%s %% of %s", Amount.of(PER_CENT * Math.abs(amount)), ofWhat.get());
    }
    String unit = unit(curve);
    String space = unit.isEmpty() || unit.equals("°") ? "" : " ";
    return Amount.of(Math.abs(inUnit(curve, amount))) + space + unit;
  }

  /** Of what a quantity without a unit is a share. */
  private static Optional<String> shareOf(Quantity quantity) {
    return switch (quantity) {
      case VERTICAL_RESTITUTION -> Optional.of("the speed of its fall");
      case TANGENTIAL_RESTITUTION -> Optional.of("its speed over the ground");
      case SPIN -> Optional.of("the spin of a rolling ball");
      default -> Optional.empty();
    };
  }

  /** What happens where the term is positive or negative; follows "the". */
  private static String change(LearnedCurve curve, double amount) {
    boolean more = amount >= 0;
    boolean slides = curve.family().variables().contains(Variable.SLIP);
    String camera = "reports of " + CameraName.of(curve.family().camera().orElse(0));
    return switch (curve.family().quantity()) {
      case ACCELERATION_ALONG ->
          slides
              ? "sliding ball is braked " + (more ? "less" : "more") + " than the model says"
              : "ball is braked " + (more ? "less" : "more") + " than the model says";
      case ACCELERATION_ACROSS -> "ball is pulled to its " + (more ? "left" : "right");
      case FRICTION -> "carpet brakes the ball " + (more ? "more" : "less");
      case ROLLING -> "rolling ball is braked " + (more ? "more" : "less");
      case SLIDING ->
          curve.component() == 0
              ? "sliding ball is braked " + (more ? "more" : "less")
              : "sliding ball is pulled to its " + (more ? "left" : "right");
      case PUSH -> "ball is pushed " + side(curve.component(), more);
      case FLOOR -> "floor is " + (more ? "higher" : "lower");
      case NAP ->
          text(
              "ball that rolls %s is braked %s",
              side(curve.component(), true), more ? "more" : "less");
      case AIR -> "air moves faster " + side(curve.component(), more);
      case VERTICAL_RESTITUTION -> "ball bounces " + (more ? "higher" : "lower");
      case TANGENTIAL_RESTITUTION ->
          "ball loses " + (more ? "less" : "more") + " speed at a bounce";
      case TURN -> "ball turns to its " + (more ? "left" : "right") + " at a bounce";
      case SPIN -> "ball has more " + (more ? "topspin" : "backspin") + " after the kick";
      case SHIFT -> camera + " are too far " + side(curve.component(), more);
      case TIME_ERROR -> "time stamps" + camera.substring(7) + " are " + (more ? "late" : "early");
    };
  }

  private static String axis(LearnedCurve curve) {
    return curve.component() == 0 ? "+x" : "+y";
  }

  private static String side(int component, boolean more) {
    if (component == 0) {
      return more ? "towards the +x goal" : "towards the −x goal";
    }
    return more ? "to the left (+y)" : "to the right (−y)";
  }

  static String variable(Variable variable) {
    return switch (variable) {
      case SPEED -> "the speed";
      case SLIP -> "how fast the ball slips";
      case TIME_SINCE_KICK -> "the time since the kick";
      case SESSION_TIME -> "the time since the session began";
      case HEADING -> "the direction of travel";
      case PLACE -> "the place on the field";
      case DISTANCE_ROLLED -> "how far the ball has rolled";
      case VERTICAL_SPEED -> "how fast the ball falls";
      case GROUND_SPEED -> "the speed over the ground";
      case HOP -> "which bounce it is";
      case IMAGE_POSITION -> "the place in the image";
    };
  }

  private static String noun(Variable variable) {
    return switch (variable) {
      case SPEED -> "speed";
      case SLIP -> "slip";
      case TIME_SINCE_KICK -> "time since the kick";
      case SESSION_TIME -> "time since the session began";
      case VERTICAL_SPEED -> "speed of the fall";
      case GROUND_SPEED -> "speed over the ground";
      case DISTANCE_ROLLED -> "distance from the kick";
      case HEADING, PLACE, HOP, IMAGE_POSITION -> "number";
    };
  }

  private static String each(Variable variable) {
    return switch (variable) {
      case SPEED, SLIP, VERTICAL_SPEED, GROUND_SPEED -> "m/s of the " + noun(variable);
      case TIME_SINCE_KICK -> "second since the kick";
      case SESSION_TIME -> "ten minutes of the session";
      case DISTANCE_ROLLED -> "metre from the kick";
      case HEADING, PLACE, HOP, IMAGE_POSITION -> step(variable);
    };
  }

  private static String step(Variable variable) {
    return switch (variable) {
      case SESSION_TIME -> "ten minutes";
      case TIME_SINCE_KICK -> "second";
      case HOP -> "bounce";
      default -> variable.unit();
    };
  }

  private static String at(Variable variable, double place) {
    return switch (variable) {
      case HOP -> "bounce " + (int) Math.ceil(place);
      case HEADING -> text("direction %s°", Amount.decimals(Math.toDegrees(place), 0));
      case SESSION_TIME -> SessionTime.at(place);
      case TIME_SINCE_KICK -> Amount.of(place) + " s after the kick";
      case DISTANCE_ROLLED -> Amount.of(place) + " m from the kick";
      default -> Amount.of(place) + " " + variable.unit();
    };
  }
}
