package fieldcal.diagnosis;

import fieldcal.diagnosis.hidden.HiddenCase;
import fieldcal.diagnosis.hidden.HiddenRun;
import fieldcal.diagnosis.hidden.Judge;
import fieldcal.diagnosis.hidden.Judgement;
import fieldcal.diagnosis.hidden.StudiedCase;
import fieldcal.diagnosis.hidden.Visibility;
import fieldcal.fit.KickFit;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** Everything about one case, for whoever wants to know why. */
final class CaseDetails {
  private final PrintStream out;

  CaseDetails(PrintStream out) {
    this.out = out;
  }

  void print(HiddenCase hidden) {
    out.println(hidden.seed() + " " + hidden);
    List<Visibility> visibility = StudiedCase.visibility(hidden);
    for (int i = 0; i < visibility.size(); i++) {
      Visibility v = visibility.get(i);
      print(
          "%s: %s, leaves %.2f σ, beside camera offsets %.2f σ (%d kicks)",
          hidden.hidden().get(i), v.level(), v.left(), v.leftWithOffsets(), v.kicks());
    }
    long start = System.nanoTime();
    HiddenRun run =
        HiddenRun.of(
            hidden, step -> print("%7.2f s  %s", 1e-9 * (System.nanoTime() - start), step));
    print(
        "%d of %d kicks are given to the diagnosis, %d commands",
        run.problem().fits().size(),
        run.truth().commandedKicks().size(),
        run.problem().commands().size());
    for (KickFit fit : run.problem().fits()) {
      print(
          "  kick %d: %s, %d detections, %.2f mm",
          fit.kick().id(), fit.kind().id(), fit.kick().observations().size(), fit.rmsMm());
    }
    run.answer().details().forEach(line -> print("%s", line));
    Judgement judgement = Judge.judge(hidden, visibility, run.truth(), run.answer());
    print("judged    %s", judgement.outcome());
    print(
        "          %s",
        judgement.found().stream()
            .map(f -> f.hidden() + " " + f.how() + " " + f.strength())
            .collect(Collectors.joining(System.lineSeparator() + "          ")));
    print("times     %s", run.times());
  }

  private void print(String format, Object... values) {
    out.println(String.format(Locale.ROOT, format, values));
  }
}
