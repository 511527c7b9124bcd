package fieldcal.app.export;

import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.export.format.ConfigForm;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;

/**
 * A program that a model can go to, read from its descriptor.
 *
 * @param name as {@code --to} takes it
 * @param title what it is, for people
 * @param files the files that it reads, each for other quantities
 */
public record Target(String name, String title, List<TargetFile> files) {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  /** All targets; each is a resource of that name. */
  private static final List<String> NAMES =
      List.of(
          "ssl-vision-processor",
          "ssl-vision",
          "geometry-text",
          "sumatra",
          "erforce-tracker",
          "erforce-realism",
          "immortals",
          "grsim",
          "robot-specs");

  /** How the names of robots' quantities end; before it may stand a team. */
  private static final List<String> LIMITS =
      List.of("velocity_max", "acceleration_max", "braking_max");

  /** Copies the list. {@inheritDoc} */
  public Target {
    files = List.copyOf(files);
  }

  /**
   * One file of a program.
   *
   * @param file its usual name
   * @param form of the file, see {@link ConfigForm#of}
   * @param entry what stands for {@code {entry}} in paths when nobody says; empty when somebody must; null when no path has it
   * @param entryMeans what an entry is, for people; null when there is none
   * @param verified where keys and units were read: files and commit of the program's source; empty when the layout is not public
   * @param unverified what is not known for certain; null when all is
   * @param newFile what a file without a base lacks; empty when it lacks nothing; begins with "refuse: " where such a file would do harm
   * @param keys the keys that are set
   * @param carries ids of effects that have a key
   * @param instead parameters that the program does not have, each with the one that it uses instead
   * @param fixed parameters that cannot be set, with the program's value, SI
   * @param unknown parameters that cannot be set and whose value in the program is not known
   * @param notes for people, whole sentences
   */
  public record TargetFile(
      String file,
      String form,
      String entry,
      String entryMeans,
      String verified,
      String unverified,
      String newFile,
      List<Key> keys,
      List<String> carries,
      Map<String, String> instead,
      Map<String, Double> fixed,
      List<String> unknown,
      List<String> notes) {
    /** Fills in what a descriptor leaves out. {@inheritDoc} */
    public TargetFile {
      keys = List.copyOf(keys);
      carries = carries == null ? List.of() : List.copyOf(carries);
      instead = instead == null ? Map.of() : Map.copyOf(instead);
      fixed = fixed == null ? Map.of() : Map.copyOf(fixed);
      unknown = unknown == null ? List.of() : List.copyOf(unknown);
      notes = notes == null ? List.of() : List.copyOf(notes);
    }

    /**
     * Whether every key and unit was read in the program's own source.
     *
     * @return false when the output must say so
     */
    public boolean isVerified() {
      return unverified == null;
    }

    /**
     * The form of the file.
     *
     * @return reader and writer
     */
    public ConfigForm configForm() {
      return ConfigForm.of(form);
    }
  }

  /**
   * A key of a file: value = factor · quantity / divisor.
   *
   * @param path names from the outside in; {@code {entry}} stands for a team, a robot type or an environment
   * @param quantity see {@link Quantities}
   * @param unit of the file; empty for a pure number
   * @param factor 1 when left out
   * @param divisor 1 when left out
   * @param min the least value that the program takes; −∞ when left out
   * @param max the largest; ∞ when left out
   * @param whole whether the program takes whole numbers alone; false when left out
   */
  public record Key(
      List<String> path,
      String quantity,
      String unit,
      Double factor,
      Double divisor,
      Double min,
      Double max,
      boolean whole) {
    /** Fills in what a descriptor leaves out. {@inheritDoc} */
    public Key {
      path = List.copyOf(path);
      unit = unit == null ? "" : unit;
      factor = factor == null ? 1 : factor;
      divisor = divisor == null ? 1 : divisor;
      min = min == null ? Double.NEGATIVE_INFINITY : min;
      max = max == null ? Double.POSITIVE_INFINITY : max;
    }

    /**
     * Whether it is of a robot, and not of the ball or the cameras.
     *
     * @return true for limits of movement
     */
    public boolean ofRobots() {
      return LIMITS.stream().anyMatch(quantity::endsWith);
    }

    double value(double quantity) {
      return factor * quantity / divisor;
    }
  }

  /**
   * The names of all targets.
   *
   * @return in the order in which they are offered
   */
  public static List<String> names() {
    return NAMES;
  }

  /**
   * A target by name.
   *
   * @param name one of {@link #names}
   * @return the target
   * @throws IllegalArgumentException when there is none of that name
   */
  public static Target of(String name) {
    if (!NAMES.contains(name)) {
      throw new IllegalArgumentException(
          "there is no target '" + name + "'; targets are " + String.join(", ", NAMES));
    }
    try (InputStream in =
        Target.class.getResourceAsStream("/fieldcal/app/export/" + name + ".json")) {
      return MAPPER.readValue(in, Target.class);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
