package fieldcal.live;

import fieldcal.movement.LimitEstimate;
import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * Compares the limits of one team with what its robots are configured to do, by the rule of the ball's parameters: one warning above 20 %, which ends below 15 %. A warning begins only when the difference exceeds three standard errors; where the robots never reached a limit, only a lower bound is
 * known, so that a warning begins only when the bound is too high.
 */
final class LimitWatch {
  private static final double SURE = 3;

  private final Team team;
  private final LiveSettings settings;
  private final Map<LimitWarning.Limit, LimitWarning> on = new EnumMap<>(LimitWarning.Limit.class);
  private ConfiguredLimits configured = new ConfiguredLimits(Double.NaN, Double.NaN, Double.NaN);

  LimitWatch(Team team, LiveSettings settings) {
    this.team = team;
    this.settings = settings;
  }

  void configure(ConfiguredLimits limits) {
    configured = limits;
  }

  /** The active warnings. */
  List<LimitWarning> warnings() {
    return List.copyOf(on.values());
  }

  /** Compares an estimate; warnings that begin or end thereby are returned. */
  List<LimitWarning> compare(TeamLimits limits, double time) {
    List<LimitWarning> changed = new ArrayList<>();
    for (LimitWarning.Limit limit : LimitWarning.Limit.values()) {
      LimitWarning now =
          new LimitWarning(team, limit, time, limit.of(limits), limit.of(configured));
      boolean before = on.containsKey(limit);
      // After a break nothing is known at first; that alone does not end a warning.
      boolean unknown = !now.estimate().known() && !Double.isNaN(now.configured());
      boolean warn = unknown ? before : off(now, before);
      if (warn != before) {
        changed.add(now);
        if (warn) {
          on.put(limit, now);
        } else {
          on.remove(limit);
        }
      }
    }
    return changed;
  }

  /** Whether a warning of this change has begun; if not, it has ended. */
  boolean isOn(LimitWarning change) {
    return on.containsKey(change.limit());
  }

  private boolean off(LimitWarning now, boolean before) {
    LimitEstimate e = now.estimate();
    double difference = e.value() - now.configured();
    if (difference < 0 && !e.reached()) {
      return false;
    }
    double limit = before ? settings.clearBelow() : settings.warnAbove();
    boolean sure = before || Math.abs(difference) > SURE * e.standardError();
    return Math.abs(now.deviation()) > limit && sure;
  }
}
