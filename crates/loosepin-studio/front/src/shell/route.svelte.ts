// Which screen is shown: kept in the fragment of the address, so that Back and reloading work.

export type Route =
  | { screen: 'gallery' }
  /** A template, or an empty sheet: nothing of it is written yet. */
  | { screen: 'try'; template: string | null }
  | { screen: 'edit' | 'report'; path: string }
  | { screen: 'compare'; before: string | null; after: string | null };

export function addressOf(route: Route): string {
  if (route.screen === 'gallery') return '#/';
  if (route.screen === 'try') return route.template === null ? '#/draw' : '#/try/' + encodeURIComponent(route.template);
  if (route.screen === 'compare') return '#/compare/' + [route.before, route.after].map((path) => encodeURIComponent(path ?? '')).join('/');
  return '#/' + route.screen + '/' + route.path.split('/').map(encodeURIComponent).join('/');
}

export function readAddress(fragment: string): Route {
  if (fragment === '#/draw') return { screen: 'try', template: null };
  const template = /^#\/try\/([a-z0-9-]+)$/.exec(fragment)?.[1];
  if (template !== undefined) return { screen: 'try', template };
  const pair = /^#\/compare\/([^/]*)\/([^/]*)$/.exec(fragment);
  const found = /^#\/(edit|report)\/(.+)$/.exec(fragment);
  if (!found && !pair) return { screen: 'gallery' };
  try {
    if (pair) {
      const [before, after] = [pair[1], pair[2]].map((text) => decodeURIComponent(text ?? '') || null);
      return { screen: 'compare', before: before ?? null, after: after ?? null };
    }
    if (!found) return { screen: 'gallery' };
    return { screen: found[1] as 'edit' | 'report', path: decodeURIComponent(found[2] ?? '') };
  } catch {
    return { screen: 'gallery' };
  }
}

class Router {
  route = $state.raw<Route>({ screen: 'gallery' });
  /** Where the person wants to go, while it is asked what becomes of the unsaved texts. */
  pending = $state.raw<Route | null>(null);
  /** The screen before this one, for the way back out of a report. */
  before: Route = { screen: 'gallery' };
  /** Whether this way out would lose something. */
  guard: ((to: Route) => boolean) | null = null;

  start(restart: () => void): void {
    this.route = readAddress(location.hash);
    addEventListener('hashchange', () => {
      // The printed address was opened again in this tab.
      if (location.hash.startsWith('#token=')) return restart();
      this.arrive(readAddress(location.hash));
    });
  }

  go(route: Route): void {
    location.hash = addressOf(route);
  }

  /** As `go`, in place of this screen: Back does not come to it again. */
  replace(route: Route): void {
    location.replace(addressOf(route));
  }

  leave(): void {
    const to = this.pending;
    this.pending = null;
    this.guard = null;
    if (to) this.go(to);
  }

  private arrive(to: Route): void {
    if (addressOf(to) === addressOf(this.route)) return;
    if (this.guard?.(to)) {
      this.pending = to;
      history.pushState(null, '', addressOf(this.route));
      return;
    }
    this.pending = null;
    this.before = this.route;
    this.route = to;
  }
}

export const router = new Router();
