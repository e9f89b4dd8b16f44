// Which chart is shown: null is the band of the deviation, else a curve over the angle of the drive. It is remembered.
import type { CurveKey, CurveQuantity } from '../messages.ts';

/** In the order of the list. */
export const quantities = ['position', 'velocity', 'acceleration', 'effort', 'transmission_angle', 'mechanical_advantage'] as const satisfies readonly CurveQuantity[];

const storedKey = 'loosepin-curve';

function stored(): CurveKey | null {
  try {
    const found = JSON.parse(localStorage.getItem(storedKey) ?? 'null') as Partial<CurveKey> | null;
    const quantity = quantities.find((one) => one === found?.quantity);
    return quantity !== undefined && typeof found?.of === 'string' ? { quantity, of: found.of } : null;
  } catch {
    return null;
  }
}

class ChosenCurve {
  key = $state.raw(stored());

  set(key: CurveKey | null): void {
    this.key = key;
    try {
      if (key) localStorage.setItem(storedKey, JSON.stringify(key));
      else localStorage.removeItem(storedKey);
    } catch {
      // A full storage, or none: the choice lasts as long as the page.
    }
  }
}

export const chosenCurve = new ChosenCurve();
