package fieldcal.effect.motion;

import fieldcal.effect.MotionEffect;
import java.util.List;

/** What differs from kick to kick by chance. It has no name and cannot be predicted; beside it, what is alike in all kicks is worth no more than it is. Its mean is a parameter of the ball, or zero. */
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
