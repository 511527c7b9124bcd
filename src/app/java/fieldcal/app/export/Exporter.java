package fieldcal.app.export;

import fieldcal.app.calibrate.InputException;
import fieldcal.app.export.ExportModel.RobotLimits;
import fieldcal.app.export.Target.Key;
import fieldcal.app.export.Target.TargetFile;
import fieldcal.app.export.format.BaseFile;
import fieldcal.app.export.format.Editor;
import fieldcal.app.export.format.Editor.Change;
import fieldcal.app.export.format.Editor.Edited;
import fieldcal.app.export.format.Setting;
import fieldcal.app.wording.Amount;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** Puts a model into the form that a target reads. */
public final class Exporter {
  private static final String REFUSE = "refuse: ";

  private final Target target;
  private final TargetFile file;
  private final ExportModel model;
  private final List<Setting> settings = new ArrayList<>();
  private final List<String> notes = new ArrayList<>();

  /** Quantities that the target takes only in part, with what is left of them. */
  private final Map<String, Double> cut = new TreeMap<>();

  /**
   * Prepares an export.
   *
   * @param target where the model shall go
   * @param model what shall go there
   * @param team whose limits are meant where a file holds those of one team: "yellow" or "blue"; empty when nobody said
   * @param entry what stands for the entry in the target's paths; empty for the usual one
   * @throws InputException when the model has nothing for the target, or it is not clear what is meant
   */
  public Exporter(Target target, ExportModel model, Optional<String> team, Optional<String> entry)
      throws InputException {
    this.target = target;
    this.model = ofTeam(model, team);
    file = choose(target, this.model);
    Set<String> unknown = new LinkedHashSet<>();
    for (Key key : file.keys()) {
      OptionalDouble quantity = this.model.quantities().of(key.quantity());
      if (quantity.isPresent()) {
        settings.add(setting(key, quantity.getAsDouble(), entry(entry)));
      } else {
        unknown.add(QuantityWords.of(key.quantity()));
      }
    }
    explain(unknown);
  }

  private static ExportModel ofTeam(ExportModel model, Optional<String> team)
      throws InputException {
    if (model.limits().isEmpty()) {
      return model;
    }
    if (team.isPresent()) {
      if (model.limits().stream().noneMatch(l -> l.team().equals(team.get()))) {
        throw new InputException(model.file() + ": has no limits of the " + team.get() + " team");
      }
      return model.ofTeam(team.get());
    }
    return model.limits().size() == 1 ? model.ofTeam(model.limits().get(0).team()) : model;
  }

  private static TargetFile choose(Target target, ExportModel model) throws InputException {
    TargetFile best =
        target.files().stream()
            .max(Comparator.comparingLong(f -> known(f, model)))
            .orElseThrow(() -> new IllegalStateException("a target without files"));
    if (known(best, model) > 0) {
      return best;
    }
    boolean robots =
        target.files().stream()
            .flatMap(f -> f.keys().stream())
            .anyMatch(k -> k.quantity().equals("velocity_max"));
    if (robots && model.limits().size() > 1) {
      throw new InputException(
          model.file() + ": has limits of both teams; say whose with --team yellow or --team blue");
    }
    String wanted =
        target.files().stream()
            .flatMap(f -> f.keys().stream())
            .map(k -> QuantityWords.of(k.quantity()))
            .distinct()
            .collect(Collectors.joining(", "));
    throw new InputException(
        model.file() + ": holds none of what " + target.name() + " takes: " + wanted);
  }

  private static long known(TargetFile file, ExportModel model) {
    return file.keys().stream()
        .filter(k -> !k.quantity().equals("roll_slope"))
        .filter(k -> model.quantities().of(k.quantity()).isPresent())
        .count();
  }

  private String entry(Optional<String> given) throws InputException {
    if (given.isPresent() || file.entry() == null || !file.entry().isEmpty()) {
      return given.or(() -> Optional.ofNullable(file.entry())).orElse("");
    }
    throw new InputException(target.name() + " needs --entry NAME: " + file.entryMeans());
  }

  private Setting setting(Key key, double quantity, String entry) {
    List<String> path = key.path().stream().map(n -> n.replace("{entry}", entry)).toList();
    double value = key.value(quantity);
    double taken = Math.max(key.min(), Math.min(key.max(), value));
    if (taken != value) {
      cut.put(key.quantity(), taken * key.divisor() / key.factor());
      notes.add(
          Editor.words(path)
              + " takes at most "
              + Amount.of(key.max())
              + " and at least "
              + Amount.of(key.min())
              + ": "
              + Amount.decimals(value, 4)
              + " becomes "
              + Amount.of(taken)
              + ".");
    }
    return new Setting(path, taken, key.unit(), key.min(), key.max(), key.whole());
  }

  private void explain(Set<String> unknown) {
    notes.addAll(model.remarks());
    if (!file.isVerified()) {
      notes.add("UNVERIFIED: " + file.unverified());
    }
    if (!unknown.isEmpty()) {
      notes.add("Not known: " + String.join(", ", unknown) + ". The target keeps its own values.");
    }
    boolean ball = file.keys().stream().anyMatch(k -> k.quantity().equals("acc_roll"));
    boolean has = model.models().flat().isPresent() || model.models().chip().isPresent();
    if (ball && has) {
      notes.addAll(new CarryingCost(file, model, cut).sentences());
    }
    if (file.keys().stream().anyMatch(k -> k.quantity().endsWith("velocity_max"))) {
      for (RobotLimits limits : model.limits()) {
        boolean meant =
            file.keys().stream().anyMatch(k -> k.quantity().startsWith(limits.team() + "."))
                || limits.values().get("velocity_max") == null
                || model.quantities().of("velocity_max").stream()
                    .anyMatch(v -> v == limits.values().get("velocity_max"));
        if (meant) {
          notes.addAll(RobotCost.sentences(limits));
        }
      }
    }
    notes.addAll(file.notes());
  }

  /**
   * The values that go to the target.
   *
   * @return in the order of the descriptor
   */
  public List<Setting> settings() {
    return List.copyOf(settings);
  }

  /**
   * The file of the target that holds them.
   *
   * @return its descriptor
   */
  public TargetFile file() {
    return file;
  }

  /**
   * What the target cannot carry and what else somebody should know.
   *
   * @return whole sentences
   */
  public List<String> notes() {
    return List.copyOf(notes);
  }

  /**
   * A new file.
   *
   * @return the export
   * @throws InputException when a new file of this target would do harm
   */
  public Export fresh() throws InputException {
    if (file.newFile().startsWith(REFUSE)) {
      throw new InputException(
          target.name()
              + " needs --base, the current "
              + file.file()
              + ": "
              + file.newFile().substring(REFUSE.length()));
    }
    List<String> all = new ArrayList<>();
    if (!file.newFile().isEmpty()) {
      all.add(file.newFile());
    }
    all.addAll(notes);
    byte[] bytes = file.configForm().render(settings, comments()).getBytes(StandardCharsets.UTF_8);
    return new Export(
        target, file, bytes, settings.stream().map(s -> new Change(s, "")).toList(), all);
  }

  /** Whoever finds the file later is told what the calibration itself says of its numbers. */
  private List<String> comments() {
    List<String> all = new ArrayList<>();
    all.add("Written by fieldcal export.");
    model
        .provenance()
        .verdict()
        .filter(verdict -> !verdict.allows())
        .ifPresent(verdict -> all.add(verdict.headline()));
    return all;
  }

  /**
   * A file in which only the exported values are new.
   *
   * @param base the present file
   * @return the export
   * @throws InputException when the file is not of the target's form, or lacks a key, with the place
   */
  public Export into(BaseFile base) throws InputException {
    Edited edited = new Editor(file.configForm(), base).with(settings);
    return new Export(target, file, edited.bytes(), edited.changes(), notes);
  }
}
