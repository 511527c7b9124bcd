package fieldcal.effect.motion;

import fieldcal.effect.MotionEffect;
import java.util.List;

/** What differs from kick to kick by chance. It has no name and cannot be predicted. It is in the model so that chance does not pass for a cause that all kicks share. Its mean is a parameter of the ball, or zero. */
interface ChanceOfKick extends MotionEffect {
  @Override
  default boolean differsFromKickToKick() {
    return true;
  }

  @Override
  default boolean hasOwnMean() {
    return false;
  }

  @Override
  default List<String> dependsOn() {
    return List.of("kick");
  }
}
