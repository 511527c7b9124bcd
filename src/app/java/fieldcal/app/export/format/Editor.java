package fieldcal.app.export.format;

import fieldcal.app.calibrate.InputException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/** Writes values into a file and leaves everything else as it is. */
public final class Editor {
  private final ConfigForm form;
  private final BaseFile base;
  private final List<Leaf> leaves;

  /**
   * One value before and after.
   *
   * @param setting what is there now
   * @param before what was there, as it stood in the file
   */
  public record Change(Setting setting, String before) {}

  /**
   * The edited file.
   *
   * @param bytes its content
   * @param changes in the order of the settings
   */
  public record Edited(byte[] bytes, List<Change> changes) {}

  /**
   * Reads a file.
   *
   * @param form of the file
   * @param base the file
   * @throws InputException when the file is not of that form, with the place
   */
  public Editor(ConfigForm form, BaseFile base) throws InputException {
    this.form = form;
    this.base = base;
    leaves = form.leaves(base);
  }

  /**
   * Puts values into the file.
   *
   * @param settings the values
   * @return the edited file
   * @throws InputException when a key is missing, is there twice or holds no number, with the place
   */
  public Edited with(List<Setting> settings) throws InputException {
    List<Change> changes = new ArrayList<>();
    List<Leaf> places = new ArrayList<>();
    for (Setting setting : settings) {
      Leaf leaf = find(setting.path());
      String before = base.text().substring(leaf.start(), leaf.end());
      requireNumber(setting.path(), leaf, before);
      changes.add(new Change(setting, before));
      places.add(leaf);
    }
    StringBuilder text = new StringBuilder(base.text());
    List<Integer> order = new ArrayList<>();
    for (int i = 0; i < places.size(); i++) {
      order.add(i);
    }
    // From the end, so that what is before stays where it is.
    order.sort(Comparator.comparingInt((Integer i) -> places.get(i).start()).reversed());
    for (int i : order) {
      text.replace(places.get(i).start(), places.get(i).end(), settings.get(i).text());
    }
    return new Edited(text.toString().getBytes(base.charset()), changes);
  }

  private void requireNumber(List<String> path, Leaf leaf, String before) throws InputException {
    try {
      Double.parseDouble(before.toLowerCase(Locale.ROOT).replace("_", ""));
    } catch (NumberFormatException e) {
      String found = before.isEmpty() ? "nothing" : "'" + before + "'";
      throw base.error(leaf.start(), words(path) + " should be a number, but is " + found);
    }
  }

  /** Where no path is the wanted one, one may end with it: settings are often part of a larger tree. */
  private Leaf find(List<String> path) throws InputException {
    List<Leaf> found = leaves.stream().filter(l -> l.path().equals(path)).toList();
    if (found.isEmpty()) {
      found = leaves.stream().filter(l -> endsWith(l.path(), path)).toList();
    }
    if (found.isEmpty()) {
      throw missing(path);
    }
    Leaf first = found.get(0);
    if (found.size() > 1) {
      int second = base.line(found.get(1).start());
      throw base.error(
          first.start(), words(path) + " is there twice, again in line " + second + "; remove one");
    }
    if (leaves.stream().anyMatch(l -> l != first && l.start() == first.start())) {
      throw base.error(
          first.start(), words(path) + " shares its value with another key; write it out");
    }
    return first;
  }

  private InputException missing(List<String> path) {
    for (int known = path.size() - 1; known > 0; known--) {
      List<String> outer = path.subList(0, known);
      for (Leaf leaf : leaves) {
        for (int from = 0; from + known <= leaf.path().size(); from++) {
          if (leaf.path().subList(from, from + known).equals(outer)) {
            return base.error(
                leaf.start(),
                words(outer)
                    + " has no "
                    + words(path.subList(known, path.size()))
                    + "; is this the right file, or of another version?");
          }
        }
      }
    }
    return new InputException(
        base.name()
            + ": has no "
            + words(path)
            + "; is this the right "
            + form.title()
            + " file, or of another version?");
  }

  private static boolean endsWith(List<String> path, List<String> end) {
    return path.size() >= end.size()
        && path.subList(path.size() - end.size(), path.size()).equals(end);
  }

  /**
   * A path in words.
   *
   * @param path names from the outside in
   * @return with " › " between them where names have blanks, else with dots
   */
  public static String words(List<String> path) {
    boolean plain = path.stream().allMatch(name -> name.matches("[\\w:.-]*"));
    return String.join(plain ? "." : " › ", path);
  }
}
