package fieldcal.diagnosis;

final class KickerBiasTest {
  private KickerBiasTest() {}
}
