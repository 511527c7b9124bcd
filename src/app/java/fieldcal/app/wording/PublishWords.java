package fieldcal.app.wording;

import fieldcal.diagnosis.Verdict;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.KickerEffect;
import fieldcal.effect.MeasurementEffect;
import fieldcal.kick.KickKind;
import fieldcal.verdict.FieldSize;
import fieldcal.verdict.PublishDecision;
import fieldcal.verdict.PublishVerdict;
import fieldcal.verdict.Reason;
import fieldcal.verdict.VerdictRule;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A verdict on a calibrated model in an operator's words; the same on the terminal, in the files and on the pages.
 *
 * @param decision its id, as in files
 * @param title a few words, for example "check first"
 * @param reasons a sentence or two each, the most serious first
 * @param notes what holds nobody back, but is worth knowing
 * @param toDo what to do next, a sentence each
 */
public record PublishWords(
    String decision, String title, List<String> reasons, List<String> notes, List<String> toDo) {
  /** What kicks mean that do not agree on a parameter; follows the sentence that says so. */
  private static final String NO_SINGLE_VALUE = " No single value describes all kicks.";

  private static final Map<String, String> KICKS_THAT_TELL =
      Map.of(
          "accSlide", "fast flat kicks (4 to 6.5 m/s)",
          "accRoll", "flat kicks that roll until they stop (2 to 4 m/s)",
          "kSwitch", "flat kicks that roll for two metres or more",
          "dampingXyFirstHop", "chips that are seen from the kick to the second impact",
          "dampingXyOtherHops", "chips that bounce three times or more",
          "dampingZ", "chips that bounce three times or more");

  /** Copies the lists. */
  public PublishWords {
    Objects.requireNonNull(decision, "decision");
    Objects.requireNonNull(title, "title");
    reasons = List.copyOf(reasons);
    notes = List.copyOf(notes);
    toDo = List.copyOf(toDo);
  }

  /**
   * Puts a verdict into words.
   *
   * @param verdict of the library
   * @return its words
   */
  public static PublishWords of(PublishVerdict verdict) {
    return new PublishWords(
        verdict.decision().id(),
        title(verdict.decision()),
        Stream.concat(
                models(verdict).stream(),
                sentences(verdict.reasons().stream().filter(PublishWords::holdsBack).toList())
                    .stream())
            .toList(),
        sentences(verdict.reasons().stream().filter(r -> !holdsBack(r)).toList()),
        toDo(verdict));
  }

  /**
   * That kicks of different fields are put together.
   *
   * @param verdict of the library
   * @return a sentence or two that name the fields and their recordings; empty where no fields are mixed
   */
  public static Optional<String> mixture(PublishVerdict verdict) {
    List<Reason> mixed = verdict.reasons().stream().filter(Reason::mixesFields).toList();
    return mixed.isEmpty() ? Optional.empty() : Optional.of(String.join(" ", sentences(mixed)));
  }

  /**
   * The verdict in one line.
   *
   * @return for example "Verdict: check first. Run diagnose on these recordings: it finds the cause."
   */
  public String headline() {
    return "Verdict: " + title + "." + (toDo.isEmpty() ? "" : " " + toDo.get(0));
  }

  private static boolean holdsBack(Reason reason) {
    return reason.decision() != PublishDecision.PUBLISH;
  }

  /** The decision about each model, where these differ. */
  private static Optional<String> models(PublishVerdict verdict) {
    Optional<PublishDecision> flat = verdict.decision(KickKind.FLAT);
    Optional<PublishDecision> chip = verdict.decision(KickKind.CHIP);
    return flat.isEmpty() || chip.isEmpty() || flat.equals(chip)
        ? Optional.empty()
        : Optional.of(
            "Flat model: " + title(flat.get()) + ". Chip model: " + title(chip.get()) + ".");
  }

  private static String title(PublishDecision decision) {
    return switch (decision) {
      case PUBLISH -> "publish";
      case RECORD_MORE -> "record more";
      case CHECK_FIRST -> "check first";
      case DO_NOT_PUBLISH -> "do not publish";
    };
  }

  /** Reasons of one sort share a sentence; those whose sentence names the model, if they are about the same one. */
  private static List<String> sentences(List<Reason> reasons) {
    Map<String, List<Reason>> alike = new LinkedHashMap<>();
    for (Reason reason : reasons) {
      alike.computeIfAbsent(sort(reason), k -> new ArrayList<>()).add(reason);
    }
    return onceOnly(alike.values().stream().flatMap(PublishWords::sentence).toList());
  }

  private static String sort(Reason reason) {
    if (reason instanceof Reason.MeanAgainstJoint m) {
      return m.id() + " " + m.beyondChance();
    }
    boolean namesNoModel = reason instanceof Reason.Imprecise;
    String model = namesNoModel ? "" : reason.model().map(KickKind::id).orElse("");
    return reason.id() + " " + model;
  }

  /** Several reasons end with the same conclusion: only the first of them says it. */
  private static List<String> onceOnly(List<String> sentences) {
    List<String> all = new ArrayList<>();
    boolean said = false;
    for (String sentence : sentences) {
      boolean concludes = sentence.endsWith(NO_SINGLE_VALUE);
      all.add(
          concludes && said
              ? sentence.substring(0, sentence.length() - NO_SINGLE_VALUE.length())
              : sentence);
      said |= concludes;
    }
    return all;
  }

  private static Stream<String> sentence(List<Reason> alike) {
    Reason first = alike.get(0);
    if (first instanceof Reason.FewKicks few) {
      return Stream.of(
          model(few.kind())
              + " has "
              + used(alike)
              + ". Each parameter needs at least "
              + few.needed()
              + " kicks.");
    }
    if (first instanceof Reason.DiffersFromPublished differs) {
      return Stream.of(
          model(differs.kind())
              + " differs from the published one: "
              + joined(
                  alike,
                  Reason.DiffersFromPublished.class,
                  r -> ParameterWords.of(r.parameter()) + " " + signed(r.percent()) + " %")
              + ".");
    }
    if (first instanceof Reason.ManyExcluded many) {
      return Stream.of(
          "The 2σ rule excludes many "
              + (many.kind() == KickKind.FLAT ? "flat kicks" : "chips")
              + ": "
              + joined(
                  alike,
                  Reason.ManyExcluded.class,
                  r ->
                      r.excluded()
                          + " of "
                          + r.kicks()
                          + " for the "
                          + ParameterWords.of(r.parameter()))
              + "."
              + NO_SINGLE_VALUE);
    }
    if (first instanceof Reason.Imprecise imprecise) {
      return Stream.of(imprecise(alike, imprecise.limit()));
    }
    if (first instanceof Reason.MeanAgainstJoint m) {
      return Stream.of(m.beyondChance() ? meanAgainstJoint(alike) : notDetermined(alike));
    }
    return alike.stream().map(PublishWords::sentence);
  }

  private static String imprecise(List<Reason> alike, double limit) {
    if (alike.size() == 1) {
      Reason.Imprecise one = (Reason.Imprecise) alike.get(0);
      return text(
          "The %s has an error of %.0f %%; at most %.0f %% is allowed.",
          ParameterWords.of(one.parameter()), one.percent(), limit);
    }
    return text("Some errors are above the %.0f %% that is allowed: ", limit)
        + joined(
            alike,
            Reason.Imprecise.class,
            r -> text("%.0f %% for the %s", r.percent(), ParameterWords.of(r.parameter())))
        + ".";
  }

  private static String meanAgainstJoint(List<Reason> alike) {
    if (alike.size() == 1) {
      Reason.MeanAgainstJoint m = (Reason.MeanAgainstJoint) alike.get(0);
      return text(
              "The %s is %s as the mean of the kicks, but %s in the joint fit: %.0f %% and %s"
                  + " standard errors apart.",
              ParameterWords.of(m.parameter()),
              value(m.parameter(), m.mean()),
              value(m.parameter(), m.joint()),
              m.percent(),
              sigmas(m))
          + whichErrors(alike)
          + NO_SINGLE_VALUE;
    }
    return "The mean of the kicks and the joint fit disagree: "
        + alike.stream()
            .map(Reason.MeanAgainstJoint.class::cast)
            .map(PublishWords::bothValues)
            .collect(Collectors.joining("; "))
        + "."
        + whichErrors(alike)
        + NO_SINGLE_VALUE;
  }

  /** Mean and joint fit are far apart, but agree within their errors. */
  private static String notDetermined(List<Reason> alike) {
    if (alike.size() == 1) {
      Reason.MeanAgainstJoint m = (Reason.MeanAgainstJoint) alike.get(0);
      return text(
              "The kicks do not determine the %s: it is %s as the mean of the kicks and %s in the"
                  + " joint fit. They differ by %.0f %%, %s standard errors; up to %.0f may be"
                  + " chance.",
              ParameterWords.of(m.parameter()),
              value(m.parameter(), m.mean()),
              value(m.parameter(), m.joint()),
              m.percent(),
              sigmas(m),
              VerdictRule.APART_SIGMAS)
          + whichErrors(alike);
    }
    return "The kicks do not determine some parameters. The mean of the kicks and the joint fit"
        + " differ by no more than their errors allow: "
        + alike.stream()
            .map(Reason.MeanAgainstJoint.class::cast)
            .map(PublishWords::bothValues)
            .collect(Collectors.joining("; "))
        + "."
        + whichErrors(alike);
  }

  /** With so many digits, and rounded so, that it does not read as the limit from which it is more than chance. */
  private static String sigmas(Reason.MeanAgainstJoint m) {
    String plain = text("%.1f", m.standardErrors());
    if (!plain.equals(text("%.1f", VerdictRule.APART_SIGMAS))) {
      return plain;
    }
    double limit = VerdictRule.APART_SIGMAS;
    double shown =
        m.beyondChance()
            ? Math.max(m.standardErrors(), limit + 0.01)
            : Math.min(m.standardErrors(), limit - 0.01);
    return text("%.2f", shown);
  }

  /** The table beside the reasons shows a larger error of the mean. */
  private static String whichErrors(List<Reason> alike) {
    return alike.stream()
            .map(Reason.MeanAgainstJoint.class::cast)
            .anyMatch(Reason.MeanAgainstJoint::withoutExcluded)
        ? " The standard error shown beside the mean is larger, since it also allows for the"
            + " excluded kicks."
        : "";
  }

  private static String bothValues(Reason.MeanAgainstJoint m) {
    return text(
        "the %s is %s as the mean, but %s in the joint fit (%.0f %% and %s standard errors"
            + " apart)",
        ParameterWords.of(m.parameter()),
        value(m.parameter(), m.mean()),
        value(m.parameter(), m.joint()),
        m.percent(),
        sigmas(m));
  }

  private static <R extends Reason> String joined(
      List<Reason> alike, Class<R> type, java.util.function.Function<R, String> words) {
    return alike.stream().map(type::cast).map(words).collect(Collectors.joining(", "));
  }

  /** Parameters with as many kicks are named together. */
  private static String used(List<Reason> alike) {
    Map<String, List<String>> parameters = new LinkedHashMap<>();
    for (Reason reason : alike) {
      Reason.FewKicks few = (Reason.FewKicks) reason;
      parameters
          .computeIfAbsent(used(few), k -> new ArrayList<>())
          .add("the " + ParameterWords.of(few.parameter()));
    }
    return parameters.entrySet().stream()
        .map(e -> e.getKey() + " for " + WordList.of(e.getValue()))
        .collect(Collectors.joining("; "));
  }

  private static String used(Reason.FewKicks few) {
    if (few.used() == 0) {
      return "no kick";
    }
    String used = few.used() == 1 ? "one" : Integer.toString(few.used());
    return few.kicks() > few.used()
        ? used + " of " + few.kicks() + " kicks"
        : used + (few.used() == 1 ? " kick" : " kicks");
  }

  private static String model(KickKind kind) {
    return kind == KickKind.FLAT ? "The flat model" : "The chip model";
  }

  private static String sentence(Reason reason) {
    if (reason instanceof Reason.NoKicks none) {
      return none.found() == 0
          ? "No kick was found in the recordings."
          : none.found() == 1
              ? "The one kick that was found cannot be used."
              : "None of the " + none.found() + " kicks that were found can be used.";
    }
    if (reason instanceof Reason.ResidualAboveNoise r) {
      return text(
              "The residuals are %s mm, %.1f times the noise of the cameras (%s mm)",
              VerdictText.mm(r.rmsMm()), r.ratio(), VerdictText.mm(r.rmsMm() / r.ratio()))
          + (holdsBack(r)
              ? ": the ball does not move as the model says."
              : text("; up to %.0f times is usual.", VerdictRule.FAR_ABOVE_NOISE));
    }
    if (reason instanceof Reason.KicksDiffer d) {
      return text(
              "One model for all kicks misses the detections by %s mm, %.1f times the noise of the"
                  + " cameras; a separate model for each kick misses them by %s mm.",
              VerdictText.mm(d.rmsMm()), d.ratio(), VerdictText.mm(d.ownRmsMm()))
          + NO_SINGLE_VALUE;
    }
    return rest(reason);
  }

  private static String rest(Reason reason) {
    if (reason instanceof Reason.ForcedKind forced) {
      return forced.kind() == KickKind.FLAT
          ? "All kicks were fitted as flat kicks, because --kind flat was given."
          : "All kicks were fitted as chips, because --kind chip was given.";
    }
    if (reason instanceof Reason.NotConverged) {
      return "The joint fit did not converge.";
    }
    if (reason instanceof Reason.NoChips n) {
      return text(
          "%d of %d kicks that were fitted as chips stay on the ground: they are flat kicks.",
          n.flat(), n.kicks());
    }
    if (reason instanceof Reason.SeveralFields f) {
      return "The fields differ in size: " + fields(f) + ". A ball model holds for one carpet.";
    }
    if (reason instanceof Reason.FaultyVision f) {
      return (f.recordings().isEmpty() ? "" : "In " + RecordingNames.of(f.recordings()) + ": ")
          + VisionFaultWords.sentence(f.fault());
    }
    if (reason instanceof Reason.OtherCameras o) {
      return "These recordings have no camera's calibration in common: "
          + o.recordings().stream().map(RecordingNames::of).collect(Collectors.joining("; "))
          + ". Either all cameras were calibrated again, or the fields differ.";
    }
    if (reason instanceof Reason.SimulatedField s) {
      return s.simulated() < s.recordings()
          ? text(
              "%d of the %d recordings %s from a simulated field: %s.",
              s.simulated(),
              s.recordings(),
              s.simulated() == 1 ? "is" : "are",
              RecordingNames.of(s.names()))
          : "The kicks are from a simulated field: the model is valid there, not on a real carpet.";
    }
    if (reason instanceof Reason.ExtendedModelOnly e) {
      return "The parameters are valid only together with the extended model ("
          + String.join(", ", names(e.effects()))
          + "), which the league's message cannot carry.";
    }
    if (reason instanceof Reason.Diagnosed d) {
      return diagnosed(d);
    }
    if (reason instanceof Reason.NotDiagnosed) {
      return "No diagnosis was run yet: diagnose shows what the model gets wrong.";
    }
    if (reason instanceof Reason.AgreesWithPublished a) {
      return model(a.kind())
          + text(
              " agrees with the published one: within its errors, or within %.0f %%.",
              VerdictRule.NOTABLE_PERCENT);
    }
    return "No "
        + reason.model().map(KickKind::id).orElse("")
        + " model is published to compare with.";
  }

  private static String fields(Reason.SeveralFields reason) {
    List<String> all = new ArrayList<>();
    for (int i = 0; i < reason.fields().size(); i++) {
      FieldSize size = reason.fields().get(i);
      List<String> recordings = reason.recordings().get(i);
      all.add(
          text("%.2f × %.2f m", size.length(), size.width())
              + (recordings.isEmpty()
                  ? " (as vision publishes it)"
                  : " (" + RecordingNames.of(recordings) + ")"));
    }
    return String.join(", ", all);
  }

  private static String diagnosed(Reason.Diagnosed d) {
    String causes = d.causes().isEmpty() ? "" : ": " + String.join(", ", names(d.causes()));
    String allowedFor =
        d.causes().isEmpty() || holdsBack(d)
            ? ""
            : " The calibration allows for this, so the ball model needs no change.";
    String small =
        holdsBack(d) || d.verdict() != Verdict.PARTLY_EXPLAINED
            ? ""
            : " Everything else that it found is small compared with the noise; programs that load"
                + " extended_model.json may predict better with it.";
    return switch (d.verdict()) {
      case MODEL_ADEQUATE -> "The diagnosis found nothing that the model gets wrong.";
      case EXPLAINED -> "The diagnosis explains what is wrong" + causes + "." + allowedFor;
      case PARTLY_EXPLAINED ->
          d.causes().isEmpty()
              ? "The diagnosis found no cause that is proven." + small
              : "The diagnosis explains a part of what is wrong"
                  + causes
                  + "."
                  + allowedFor
                  + small;
      case UNEXPLAINED_STRUCTURE ->
          "The diagnosis found that the model is wrong, but no cause for it.";
    };
  }

  private static List<String> names(List<String> effects) {
    return effects.stream().map(EffectName::of).distinct().toList();
  }

  // ---- what to do ----

  private static List<String> toDo(PublishVerdict verdict) {
    Set<String> all = new LinkedHashSet<>();
    verdict.reasons().stream()
        .filter(PublishWords::asksToSeparate)
        .forEach(reason -> all.add(advice(reason, verdict.diagnose())));
    if (!all.isEmpty()) {
      // What else is wrong may come from the mixture, and other kicks may be missing afterwards.
      return thenReadAgain(List.copyOf(all));
    }
    for (Reason reason : verdict.reasons()) {
      if (holdsBack(reason)) {
        String advice = advice(reason, verdict.diagnose());
        if (!advice.isEmpty()) {
          all.add(advice);
        }
      }
    }
    Set<String> wanted = new LinkedHashSet<>();
    boolean moreHelp =
        verdict.reasons().stream()
            .filter(PublishWords::holdsBack)
            .allMatch(PublishWords::asksForMoreKicks);
    for (Reason reason : verdict.reasons()) {
      if (reason instanceof Reason.OfModel of
          && (reason.decision() == PublishDecision.RECORD_MORE
              || moreHelp && asksForMoreKicks(reason))) {
        wanted.add(KICKS_THAT_TELL.get(of.parameter()));
      }
    }
    if (!wanted.isEmpty()) {
      all.add("Record " + beginners(verdict) + WordList.of(List.copyOf(wanted)) + ".");
    }
    if (verdict.decision() == PublishDecision.PUBLISH) {
      all.add(publish(verdict.reasons()));
    }
    if (all.isEmpty()) {
      all.add(
          "Look at the kicks with excluded values or large residuals, and drop those that went"
              + " wrong.");
    }
    return List.copyOf(all);
  }

  /** Whether more kicks would settle it. Where kicks contradict one model, more of them do not determine its parameters either. */
  private static boolean asksForMoreKicks(Reason reason) {
    return reason.decision() == PublishDecision.RECORD_MORE
        || reason instanceof Reason.MeanAgainstJoint m && !m.beyondChance();
  }

  private static List<String> thenReadAgain(List<String> advice) {
    List<String> all = new ArrayList<>(advice);
    String last = all.remove(all.size() - 1);
    all.add(last.replaceFirst("\\.$", ", then read the new verdict."));
    return all;
  }

  /** How many kicks to record where there are hardly any. */
  private static String beginners(PublishVerdict verdict) {
    List<String> kinds =
        Stream.of(KickKind.values())
            .filter(
                kind ->
                    verdict.reasons().stream()
                        .anyMatch(
                            r ->
                                r instanceof Reason.FewKicks few
                                    && few.kind() == kind
                                    && few.kicks() < few.needed()))
            .map(kind -> kind == KickKind.FLAT ? "twelve flat kicks" : "twelve chips")
            .toList();
    return kinds.isEmpty() ? "" : "at least " + WordList.of(kinds) + ", among them ";
  }

  /** Where kicks are together that do not or may not belong to one field, all else comes after that is settled. */
  private static boolean asksToSeparate(Reason reason) {
    return reason.mixesFields() || reason instanceof Reason.OtherCameras;
  }

  private static String publish(List<Reason> reasons) {
    boolean changes =
        reasons.stream()
            .anyMatch(
                r ->
                    r instanceof Reason.DiffersFromPublished
                        || r instanceof Reason.NothingPublished);
    boolean simulated =
        reasons.stream()
            .anyMatch(r -> r instanceof Reason.SimulatedField s && s.simulated() == s.recordings());
    if (simulated) {
      return changes
          ? "Use the numbers on this simulated field only; for a real one, record kicks there."
          : "Nothing has to be changed on this simulated field: its published ball model is"
              + " right.";
    }
    boolean diagnosed = reasons.stream().noneMatch(r -> r instanceof Reason.NotDiagnosed);
    return changes
        ? (diagnosed ? "Enter" : "Run diagnose, which may change this verdict; then enter")
            + " the numbers in SSL-Vision, or send them from the console."
        : "Nothing has to be changed in the ball model: the published one is right.";
  }

  private static String advice(Reason reason, boolean diagnose) {
    if (reason instanceof Reason.MeanAgainstJoint
        || reason instanceof Reason.ManyExcluded
        || reason instanceof Reason.ResidualAboveNoise
        || reason instanceof Reason.KicksDiffer) {
      return diagnose ? "Run diagnose on these recordings: it looks for the cause." : "";
    }
    if (reason instanceof Reason.NoKicks none) {
      return none.found() == 0
          ? "Record kicks of a ball that rests in view of a camera before it is kicked."
          : "Look at the reasons in the table of kicks, then record more kicks.";
    }
    if (reason instanceof Reason.ForcedKind forced) {
      return "Calibrate without --kind "
          + forced.kind().id()
          + ": some kicks may be "
          + (forced.kind() == KickKind.FLAT ? "chips." : "flat.");
    }
    if (reason instanceof Reason.NotConverged) {
      return "Look at the kicks with the largest residuals, and drop those that went wrong.";
    }
    if (reason instanceof Reason.NoChips) {
      return "Calibrate without --kind chip.";
    }
    if (reason instanceof Reason.FaultyVision f) {
      return VisionFaultWords.advice(f.fault());
    }
    if (reason instanceof Reason.SeveralFields && !reason.mixesFields()) {
      return "Use recordings of the field that vision publishes now.";
    }
    if (reason instanceof Reason.SeveralFields || reason instanceof Reason.OtherCameras) {
      return "Calibrate each field on its own.";
    }
    if (reason instanceof Reason.SimulatedField) {
      return "Leave the simulated recordings out.";
    }
    if (reason instanceof Reason.ExtendedModelOnly) {
      return "Give these parameters only to programs that use extended_model.json; for all others,"
          + " calibrate without it.";
    }
    if (reason instanceof Reason.Diagnosed d) {
      return afterDiagnosis(d);
    }
    return "";
  }

  /** What can be mended is to be mended; the ball model that vision publishes cannot hold the rest. */
  private static String afterDiagnosis(Reason.Diagnosed d) {
    if (d.verdict() == Verdict.UNEXPLAINED_STRUCTURE) {
      return "Record the kicks that the diagnosis proposes, and run diagnose again before you"
          + " publish.";
    }
    List<String> mended = d.causes().stream().filter(PublishWords::canBeMended).toList();
    List<String> others = d.causes().stream().filter(id -> !canBeMended(id)).toList();
    if (mended.isEmpty()) {
      return "Let your AI load extended_model.json, which contains what the diagnosis found;"
          + " vision's ball model cannot hold it.";
    }
    String rest = WordList.of(names(others));
    return "Correct "
        + WordList.of(names(mended).stream().map(name -> "the " + name).toList())
        + " and record again."
        + (others.isEmpty()
            ? ""
            : " "
                + Character.toUpperCase(rest.charAt(0))
                + rest.substring(1)
                + (names(others).size() == 1 ? " remains" : " remain")
                + ": let your AI load extended_model.json.");
  }

  /** Whether it is an error of a camera, a clock or a kicker. */
  private static boolean canBeMended(String effect) {
    return EffectCatalogue.find(effect)
        .filter(e -> e instanceof MeasurementEffect || e instanceof KickerEffect)
        .isPresent();
  }

  private static String value(String parameter, double value) {
    return Amount.minus(text("%.3f", value)) + ParameterWords.unit(parameter);
  }

  private static String signed(double percent) {
    return Amount.minus(text("%+.0f", percent));
  }

  private static String text(String format, Object... args) {
    return String.format(Locale.ROOT, format, args);
  }
}
