package fieldcal.benchmark;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * What a benchmark found, as the table of docs/benchmarks.md: a row for each number, with its goal and a verdict that allows for the sampling error. Not thread-safe.
 */
public final class Findings {
  /** Standard errors that chance rarely exceeds: 95 % are within two. */
  private static final double CHANCE = 2;

  private final List<Row> rows = new ArrayList<>();

  /** Whether a goal is met. */
  enum Verdict {
    MET("met"),
    MISSED("**missed**"),
    OPEN("not decided"),
    NONE("–");

    final String text;

    Verdict(String text) {
      this.text = text;
    }
  }

  private record Row(String what, String measured, String goal, Verdict verdict) {}

  /**
   * A number without a goal.
   *
   * @param what it is
   * @param measured with its unit
   */
  public void note(String what, String measured) {
    rows.add(new Row(what, measured, "–", Verdict.NONE));
  }

  /**
   * A number without a sampling error, such as a time or a count of what must never happen.
   *
   * @param what it is
   * @param format of the value and of its goal, with the unit
   * @param value measured
   * @param goal it has
   */
  public void value(String what, String format, double value, Goal goal) {
    Verdict verdict = goal.met(value) ? Verdict.MET : Verdict.MISSED;
    rows.add(new Row(what, String.format(Locale.ROOT, format, value), goal.toString(), verdict));
  }

  /**
   * The best or worst of several numbers that have a sampling error. Chance pushes it towards its goal's limit, so it meets the goal where it keeps it, and misses it where the error does not explain that.
   *
   * @param what it is
   * @param format of the value, with the unit
   * @param value measured
   * @param error standard error of each of the numbers
   * @param goal it has
   */
  public void extreme(String what, String format, double value, double error, Goal goal) {
    boolean explained =
        goal.met(value - CHANCE * error)
            || goal.met(value + CHANCE * error)
            || value - CHANCE * error < goal.lowest() && value + CHANCE * error > goal.highest();
    Verdict verdict = goal.met(value) ? Verdict.MET : explained ? Verdict.OPEN : Verdict.MISSED;
    String measured = String.format(Locale.ROOT, format, value);
    rows.add(new Row(what, measured, goal.toString(), verdict));
  }

  /**
   * A share of drawn cases, judged by its interval of 95 %.
   *
   * @param what is counted
   * @param count of cases
   * @param of how many
   * @param goal it has
   */
  public void share(String what, int count, int of, ShareGoal goal) {
    rows.add(new Row(what, counted(count, of), goal.toString(), goal.decide(count, of)));
  }

  /**
   * A share of drawn cases that should be neither too small nor too large.
   *
   * @param what is counted
   * @param count of cases
   * @param of how many
   * @param lowest share allowed
   * @param highest share allowed
   */
  public void share(String what, int count, int of, double lowest, double highest) {
    Verdict least = ShareGoal.atLeast(lowest).decide(count, of);
    Verdict most = ShareGoal.atMost(highest).decide(count, of);
    boolean met = least == Verdict.MET && most == Verdict.MET;
    boolean missed = least == Verdict.MISSED || most == Verdict.MISSED;
    String goal = String.format(Locale.ROOT, "%.0f to %.0f %%", 100 * lowest, 100 * highest);
    rows.add(
        new Row(
            what,
            counted(count, of),
            goal,
            met ? Verdict.MET : missed ? Verdict.MISSED : Verdict.OPEN));
  }

  /**
   * A share of drawn cases without a goal.
   *
   * @param what is counted
   * @param count of cases
   * @param of how many
   */
  public void share(String what, int count, int of) {
    note(what, counted(count, of));
  }

  private static String counted(int count, int of) {
    if (of == 0) {
      return "no case";
    }
    double[] range = ShareGoal.range(count, of);
    return String.format(
        Locale.ROOT,
        "%d of %d: %.1f %% (%.1f to %.1f %%)",
        count,
        of,
        100.0 * count / of,
        100 * range[0],
        100 * range[1]);
  }

  /**
   * Prints the table, when there is a row, and the verdict on all goals.
   *
   * @param out where to
   */
  public void print(PrintStream out) {
    if (rows.isEmpty()) {
      return;
    }
    out.printf("%n| what | measured | goal | verdict |%n|---|---|---|---|%n");
    for (Row row : rows) {
      out.printf(
          "| %s | %s | %s | %s |%n", row.what(), row.measured(), row.goal(), row.verdict().text);
    }
    out.printf(
        "%nGoals: %d met, %d missed, %d not decided.%n",
        count(Verdict.MET), count(Verdict.MISSED), count(Verdict.OPEN));
  }

  private long count(Verdict verdict) {
    return rows.stream().filter(row -> row.verdict() == verdict).count();
  }
}
