package fieldcal.effect.learned;

import java.util.Locale;

/** A simple formula in words, with units. */
final class FormulaText {
  private FormulaText() {}

  static String of(SimpleFormula.Kind kind, double amount, double place, LearnedCurve curve) {
    Quantity quantity = curve.family().quantity();
    Variable variable = curve.family().variables().get(0);
    double sign = quantity == Quantity.ACCELERATION_ALONG ? -1 : 1;
    double a = sign * amount;
    String what = noun(quantity, curve.component());
    String unit = unit(quantity.unit());
    String per = variable.unit().isEmpty() ? variable.label() : variable.unit();
    String size = number(Math.abs(a)) + unit;
    String verb = a < 0 ? "falls" : "grows";
    String side = a < 0 ? "lower" : "higher";
    return switch (kind) {
      case NONE -> what + ": its errors are too large for a formula";
      case SLOPE -> what + " " + verb + " by " + size + " per " + per;
      case QUADRATIC ->
          what
              + " "
              + verb
              + " by "
              + size
              + " times the square of the "
              + name(variable)
              + " in "
              + per;
      case INVERSE ->
          what + " is " + side + " by " + size + " divided by the " + name(variable) + " in " + per;
      case ONSET ->
          what + " " + verb + " by " + size + " per " + per + " above " + at(place, variable);
      case STEP -> what + " is " + side + " by " + size + " from " + at(place, variable) + " on";
      case SINE -> sine(what, number(amount) + unit, sign < 0, place, curve);
      case GRADIENT ->
          what
              + " grows by "
              + number(amount)
              + unit
              + " per m towards direction "
              + degrees(sign < 0 ? place + Math.PI : place);
      case STEP_X -> what + " is " + side + " by " + size + " from x = " + number(place) + " m on";
      case STEP_Y -> what + " is " + side + " by " + size + " from y = " + number(place) + " m on";
      case CURVE ->
          what
              + " varies between "
              + number(Math.min(sign * lowest(curve), sign * highest(curve)))
              + " and "
              + number(Math.max(sign * lowest(curve), sign * highest(curve)))
              + unit
              + (variable == Variable.SESSION_TIME && curve.family().isPeriodic()
                  ? every(curve)
                  : " with the " + name(variable));
    };
  }

  private static double lowest(LearnedCurve curve) {
    return curve.certainlyLowest().orElseGet(curve::lowest).value();
  }

  private static double highest(LearnedCurve curve) {
    return curve.certainlyHighest().orElseGet(curve::highest).value();
  }

  private static String sine(
      String what, String size, boolean turned, double place, LearnedCurve curve) {
    String varies = what + " varies by ±" + size;
    return switch (curve.family().variables().get(0)) {
      case HEADING -> {
        double period = ((Harmonics) curve.family().basis()).period();
        String most = degrees(turned ? place + period / 2 : place);
        boolean fullTurn = period > Math.PI;
        yield varies
            + " with the heading, most towards "
            + most
            + (fullTurn ? "" : " and every " + degrees(period) + " from there");
      }
      case SESSION_TIME -> varies + every(curve);
      default -> varies + " during each turn of the ball";
    };
  }

  private static String every(LearnedCurve curve) {
    return " every " + number(((Harmonics) curve.family().basis()).period()) + " s";
  }

  private static String noun(Quantity quantity, int component) {
    return switch (quantity) {
      case ACCELERATION_ALONG -> "deceleration";
      case ACCELERATION_ACROSS -> "acceleration to the ball's left";
      case FRICTION -> "relative friction";
      case ROLLING -> "relative rolling deceleration";
      case SLIDING ->
          component == 0 ? "relative friction while sliding" : "pull to the left while sliding";
      case PUSH -> "acceleration towards " + axis(component);
      case FLOOR -> "height of the floor";
      case NAP -> "relative rolling deceleration towards " + axis(component);
      case AIR -> "velocity of the air towards " + axis(component);
      case VERTICAL_RESTITUTION -> "vertical restitution";
      case TANGENTIAL_RESTITUTION -> "tangential restitution";
      case TURN -> "turn to the left at an impact";
      case SPIN -> "spin after the kick";
      case SHIFT -> component == 0 ? "reported x" : "reported y";
      case TIME_ERROR -> "lateness of the time stamps";
    };
  }

  private static String axis(int component) {
    return component == 0 ? "+x" : "+y";
  }

  private static String name(Variable variable) {
    return variable.label().replace('_', ' ');
  }

  private static String at(double place, Variable variable) {
    return variable == Variable.HOP
        ? "impact " + (int) Math.ceil(place)
        : number(place) + unit(variable.unit());
  }

  private static String unit(String unit) {
    return unit.isEmpty() ? "" : " " + unit;
  }

  private static String degrees(double angle) {
    double turned = Math.IEEEremainder(angle, 2 * Math.PI);
    return String.format(Locale.ROOT, "%.0f°", Math.toDegrees(turned)).replace('-', '−');
  }

  /** Two digits. */
  private static String number(double value) {
    double size = Math.abs(value);
    int places = size == 0 ? 0 : 1 - (int) Math.floor(Math.log10(size));
    String text = String.format(Locale.ROOT, "%." + Math.max(0, Math.min(5, places)) + "f", value);
    return text.replace('-', '−');
  }
}
