// All strings of the front end: whole sentences, with named holes. Words of the server are shown as they come.
import type { EditTool, JoinKind, RecordKind } from './editing/toolset.ts';
import type { KeyGroup, KeyName } from './shell/keys.ts';
import type { PaneName } from './shell/panes.svelte.ts';
import type { CurveQuantity, Document, Job, ResultKind, ForceView, JointView, TextState, Verdict } from './messages.ts';

const whole = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });
const relative = new Intl.RelativeTimeFormat('en', { numeric: 'auto' });

function count(number: number, one: string, many: string): string {
  return whole.format(number) + ' ' + (number === 1 ? one : many);
}

/** Thousandths of a millimetre are finer than any drawing. */
const short = (mm: number): string => String(Math.round(mm * 1000) / 1000 + 0);

export const words = {
  studio: 'loosepin studio',
  fileName: (which: Document): string => which + '.toml',
  percent: (share: number): string => whole.format(share * 100) + ' %',
  input: (value: number, isAngle: boolean): string => (isAngle ? words.degrees(value) : `${Number(value.toPrecision(3))} s`),
  degrees: (angle: number): string => whole.format(((Math.round(angle) % 360) + 360) % 360) + '°',

  ago(atMs: number, now: number): string {
    const seconds = (atMs - now) / 1000;
    const units: [Intl.RelativeTimeFormatUnit, number][] = [['day', 86400], ['hour', 3600], ['minute', 60]];
    for (const [unit, length] of units) {
      if (Math.abs(seconds) >= length) return relative.format(Math.round(seconds / length), unit);
    }
    return 'just now';
  },

  verdict(verdict: Verdict): string {
    const names: Record<Verdict, string> = { met: 'met', not_met: 'not met', undecided: 'undecided', promised: 'promised' };
    return names[verdict];
  },

  wire: {
    lost: (seconds: number): string =>
      `The connection to loosepin is lost. The next attempt is in ${count(seconds, 'second', 'seconds')}. Your text is kept.`,
    refusedTitle: 'This page has no access key for the studio',
    refused: 'Open the address that `loosepin serve` printed. The key is at its end and is kept until this tab is closed.',
    otherKey: 'loosepin was started anew, and this page has the old access key: nothing can be saved from here. Your text stays. Open the address that `loosepin serve` printed in this tab, and go on.',
    unreachable: 'loosepin does not respond. Perhaps it was stopped: start `loosepin serve` again.',
    unknown: 'loosepin returned an error without an explanation.',
    close: 'Close this message',
  },

  keys: {
    title: 'Keys',
    groups: { canvas: 'Canvas', parts: 'Parts of the drawing', tools: 'Tools', texts: 'Texts and numbers', panes: 'Panes', pages: 'Pages' } as Record<KeyGroup, string>,
    list: {
      play: ['Space', 'plays or stops'],
      back: ['[', 'turns the drive back by 1 degree'],
      forth: [']', 'turns the drive forward by 1 degree'],
      zoomIn: ['+', 'zooms in; so does the wheel'],
      zoomOut: ['−', 'zooms out'],
      fit: ['0', 'shows all'],
      pan: ['Arrows', 'on the canvas: move it'],
      drag: ['Space + drag', 'moves the canvas; so does a drag beside all parts, or the middle button'],
      nudge: ['Arrows', 'on a pin: move it by one step, with Shift by ten'],
      choose: ['Enter', 'selects it, or applies the tool'],
      trace: ['t', 'on a pin or a point: draws its path, or hides it'],
      remove: ['Delete', 'deletes it'],
      free: ['Alt', 'while dragging: values are not rounded'],
      cancel: ['Escape', 'cancels a drag; deselects the tool'],
      save: ['Ctrl+S', 'saves'],
      undo: ['Ctrl+Z', 'undoes, in both texts'],
      redo: ['Ctrl+Shift+Z', 'redoes'],
      step: ['↑ ↓', 'in a number: one step; with Shift ten steps, with Alt a tenth'],
      nextProblem: ['F8', 'in a text: goes to the next problem'],
      resize: ['Arrows', 'on the line between two panes: move it; Home and End to its limits'],
      reset: ['Enter', 'on such a line: sets it back'],
      close: ['Escape', 'closes the list of runs, of problems or of keys'],
      help: ['?', 'shows these keys'],
      find: ['/', 'finds a mechanism in the gallery'],
    } as Record<KeyName, [string, string]>,
    single: 'Use the keys Space, [, ], /, ?, +, −, 0, t and the letters of tools',
  },

  gallery: {
    heading: 'Mechanisms',
    folder: (folder: string): string => `Folder ${folder}`,
    find: 'Find',
    findHint: 'Name of a study, a model or a mechanism',
    continue: 'Your mechanisms',
    draw: 'Draw from nothing',
    /** Folder of what is drawn. */
    blank: 'drawn',
    import: 'Import a drawing (DXF)',
    unit: 'Unit',
    ownUnit: 'of the drawing',
    start: 'Start from a mechanism',
    startHint: 'A click opens one. Nothing is written before you save.',
    results: 'Results',
    compare: 'Compare two results',
    loading: 'Reading the folder …',
    none: 'There are no models in this folder yet. Start from a mechanism below, draw one, or import a drawing.',
    noneFound: (text: string): string => `Nothing found for “${text}”.`,
    noTemplates: 'There are no templates.',
    truncated: 'The folder contains more than is shown here. Use the search, or serve a smaller folder.',
    withModel: (path: string): string => `with ${path}`,
    resultKind: { study: 'Study', simulation: 'Simulation', motion: 'Motion', sweep: 'Sweep', identification: 'Identification', networks: 'Networks' } satisfies Record<ResultKind, string>,
    openReport: 'Report',
    openReportOf: (title: string): string => `Report of ${title}`,
    allResults: (number: number): string => `Show all ${whole.format(number)} results`,
    moving: 'Move the drawings',
    noDrawing: 'no drawing',
    failed: 'The folder could not be read.',
    importFailed: (reason: string): string => `The drawing was not imported: ${reason}`,
    tooLarge: 'It has more than 4 MiB. Save only the lines and circles of the mechanism.',
    imported: (notes: string[]): string => `Imported: ${notes.join('; ')}. Fill in every "?": see the problems below.`,
    again: 'Try again',
  },

  editor: {
    back: 'Gallery',
    loading: 'Reading the texts …',
    failed: 'The texts could not be opened.',
    unsaved: 'unsaved',
    saved: 'saved',
    undo: 'Undo',
    redo: 'Redo',
    save: 'Save',
    saving: 'Saving …',
    saveAndRun: 'Save and run',
    noStudy: 'Only a study can be run, but this model was opened without one.',
    noModel: 'The study does not name a model that can be read. Correct the line `model = …`, save, and open it again.',
    broughtBack: (ago: string): string => `Changes of ${ago} that were not saved are here again. Undo takes them back.`,
    elsewhere: 'Another tab has changes of these texts that are not saved. They are not shown here.',
    olderDraft: (ago: string): string => `There are changes of ${ago} that were not saved, of an older text: the file has changed since.`,
    takeDraft: 'Show them',
    dropDraft: 'Discard them',
    leaveQuestion: 'The texts have changes that are not saved.',
    saveAndLeave: 'Save and leave',
    leaveWithout: 'Leave without saving',
    stay: 'Stay',
    changed: (path: string): string => `${path} was changed on disk by another program.`,
    changedInTab: (path: string): string => `${path} was saved in another tab of the studio.`,
    load: 'Load the version on disk',
    keep: 'Keep mine and overwrite',
    saveFailed: (message: string): string => `The texts could not be saved. ${message}`,
    broken: 'Not saved, because the texts have an error. It is the first one under Problems.',
    showBroken: 'Show it',
    saveBroken: 'Save with the error',
    notAdopted: (message: string): string => `The values of the result were not copied. ${message}`,
    runNeedsConnection: 'The study was saved but not started, because the connection is lost.',
  },

  outline: {
    heading: 'Outline',
    forces: 'Springs and loads',
    bodies: 'Bodies',
    joints: 'Joints',
    drives: 'Drives',
    loops: 'Loops',
    outputs: 'Outputs',
    none: 'none',
    noPlay: 'no play',
    play: (play: string): string => `play ${play.replace(/^c = /, '')}`,
    goTo: (name: string): string => `Show ${name} in the text`,
    empty: 'The outline appears when the model can be read.',
  },

  drawing: {
    heading: 'Drawing',
    pin: (joint: JointView): string => `${joint.name}, ${joint.kind}${joint.play === null ? '' : ', ' + joint.play}. Drag it, or move it with the arrow keys.`,
    point: (name: string): string => `${name}, a point without a joint. Drag it, or move it with the arrow keys.`,
    guide: (joint: string, angle: string): string => `Line of ${joint}, ${angle}. Drag it to turn it in steps of 15 degrees, or use the arrow keys.`,
    force: ({ name, kind }: ForceView): string => `${name}, ${kind}. Press Enter to select it, Delete to delete it.`,
    drop: (name: string): string => `Release to pin it to ${name}. With Alt, it only moves there.`,
    stale: 'The drawing shows the last text that could be read.',
    incomplete: 'It does not move yet. See the problems.',
    cut: 'The analysis of these texts took longer than 2 s and was stopped. The view shows the texts before.',
    coarse: 'With more positions, the analysis took longer than 2 s and was stopped.',
    tooLarge: 'There is no drawing: the analysis of these texts took longer than 2 s and was stopped.',
    none: 'There is no drawing: the model cannot be read yet. See the problems below.',
    still: 'The model can be read, but there is no drawing of it.',
    loading: 'Making the drawing …',
    play: 'Play',
    pause: 'Pause',
    angle: 'Drive angle',
    /** An end of what the drive can use. */
    end: (degrees: number): string => `${degrees.toFixed(1).replace('-', '−')}°`,
    range: (ends: readonly [number, number]): string => `The drive can turn from ${words.drawing.end(ends[0])} to ${words.drawing.end(ends[1])}, not further: the links do not close beyond.`,
    time: 'Time',
    step: (steps: number, isAngle: boolean): string => (steps < 0 ? '−' : '+') + (isAngle ? '1°' : ''),
    back: (isAngle: boolean): string => (isAngle ? 'Turn back by 1 degree' : 'Go back by a hundredth of the time'),
    forth: (isAngle: boolean): string => (isAngle ? 'Turn forward by 1 degree' : 'Go forward by a hundredth of the time'),
  },

  space: {
    canvas: 'Mechanism in space. Arrow keys turn it, Home shows it as at first, plus and minus zoom, 0 fits.',
    hint: 'Drag to turn · Shift + drag to move · click a name to select its joint · links and joints are changed in the text',
    sides: 'View',
    isometric: 'Isometric',
    front: 'Front',
    side: 'Side',
    top: 'Top',
  },

  canvas: {
    name: 'Canvas. Arrow keys move it, plus and minus zoom, 0 fits.',
    zoom: 'Zoom',
    larger: 'Zoom in (+)',
    smaller: 'Zoom out (−)',
    fit: 'Fit: show all (0)',
    fitShort: 'Fit',
    scale: (mm: number): string => (mm >= 1000 ? `${mm / 1000} m` : mm < 0.001 ? `${Number((mm * 1e6).toPrecision(3))} nm` : mm < 0.1 ? `${Number((mm * 1000).toPrecision(3))} µm` : `${Number(mm.toPrecision(3))} mm`),
    zone: (factor: number): string => (factor === 1 ? 'zone true to scale' : `zone of the path × ${factor}`),
    zoneMeans: 'Where the point can be, without dynamics: the largest effect of the play plus the 95 % ellipse of the tolerances. Its outline shows it at the angle of the drive; inside it are the play alone and, in blue, the ellipse alone.',
    play: (factor: number): string => (factor === 1 ? 'play true to scale' : `play × ${factor}`),
  },

  band: {
    limit: (written: string): string => `Limit ±${written}. Drag it, or move it with the arrow keys.`,
    addLimit: 'Add a limit',
    heading: ['Deviation', 'without dynamics'],
    output: 'Output',
    chart: 'Chart of the band',
    none: 'No output has a deviation: add play to a joint, or a distribution to a number.',
    incomplete: 'The band appears when the mechanism moves.',
    hover: 'Point at the chart to move the mechanism.',
    parts: 'Contributions of tolerances and play to the band',
    sentences: 'All outputs, in sentences',
    play: 'play',
    part: 'tolerance',
  },

  curves: {
    quantity: 'Quantity of the chart',
    of: 'Output, point or loop of the chart',
    quantities: {
      position: 'Position',
      velocity: 'Velocity',
      acceleration: 'Acceleration',
      effort: 'Drive effort',
      transmission_angle: 'Transmission angle',
      mechanical_advantage: 'Mechanical advantage',
    } satisfies Record<CurveQuantity, string>,
    named: (quantity: CurveQuantity, of: string): string => `${words.curves.quantities[quantity]} of ${of}`,
    chart: (name: string): string => `${name}. Arrow keys turn the drive.`,
    at: (input: number, isAngle: boolean): string =>
      `at ${Number.isInteger(input) || !isAngle ? words.input(input, isAngle) : (((input % 360) + 360) % 360).toFixed(1) + '°'}`,
    value: (value: string, unit: string): string => (unit === '' ? value : unit === '°' ? value + unit : `${value} ${unit}`),
    none: 'no finite value',
    spoken: (at: string, readings: { words: string; text: string }[]): string =>
      `${at}: ${readings.map((one) => (readings.length > 1 ? one.words + ' ' : '') + one.text).join(', ')}`,
  },

  trace: {
    short: 'Trace',
    of: (point: string): string => `Trace ${point}: draw its path`,
    recorded: 'path recorded',
  },

  numbers: {
    tab: 'Numbers',
    find: 'Find a number',
    none: 'Numbers appear when the model can be read.',
    noneFound: (text: string): string => `No number found for “${text}”.`,
    scrub: 'Drag sideways to change',
    groups: {
      parameter: 'Parameters',
      joint: 'Joints',
      drive: 'Drives',
      scatter: 'Random, as in the study',
      unknown: 'Unknown, as in the study',
      body: 'Bodies',
      contact: 'Contacts',
      other: 'Other numbers',
    } as Record<string, string>,
    lower: 'lower end',
    upper: 'upper end',
    goTo: (label: string): string => `Show ${label} in the text`,
  },

  build: {
    tools: 'Tools',
    names: { move: 'Move', link: 'Link', plate: 'Plate', join: 'Join', slider: 'Slider', ground: 'Ground', motor: 'Motor', record: 'Record', delete: 'Delete' } satisfies Record<EditTool, string>,
    keys: { move: 'v', link: 'l', plate: 'p', join: 'j', slider: 's', ground: 'g', motor: 'm', record: 'r', delete: 'd' } satisfies Record<EditTool, string>,
    first: 'Click where the crank turns (a pin on the ground, with the motor), then its other end.',
    optionsOf: (tool: string): string => `Options of the tool ${tool}`,
    hints: {
      move: '',
      link: 'Click where the link begins: a point, a link, or a free place. With Shift it begins on the ground.',
      plate: 'Click a link to add points to it.',
      join: 'Click a point, then the point to join to it.',
      slider: 'Click a point to make it a pin in a block, in a guide on the ground.',
      ground: 'Click a point to pin it to the ground.',
      motor: 'Click a pin without play to put the motor there.',
      record: 'Click what is to be recorded: a point, or a link and then the place of a new point on it.',
      delete: 'Click a pin, a point or a link to delete it. Everything that is deleted with it is shown first.',
    } satisfies Record<EditTool, string>,
    chain: (start: string): string => `Click where the next link ends; click ${start} again to pin it to the ground; Escape ends.`,
    next: (tool: EditTool, start: string): string =>
      tool === 'link'
        ? `The link begins at ${start}. Click where it ends; with Shift, the end is on the ground.`
        : tool === 'plate'
          ? `Click places or points that belong to ${start}. Escape ends it.`
          : tool === 'record'
            ? `Click the place of the new point on ${start}; it may lie beside the link.`
            : `Click the point to join to ${start}.`,
    at: ([x, y]: readonly [number, number]): string => `${short(x)}, ${short(y)} mm`,
    /** Length and direction of a link that is being drawn. */
    reach: (mm: number, degrees: number): string => `${short(mm)} mm, ${degrees.toFixed(1)}°`,
    equal: (link: string): string => `as long as ${link}`,
    playAt: (play: string | null): string => `play ${play ?? 'none'}`,
    target: (points: string[], at: [number, number]): string => `${points.join(' and ')}, at ${words.build.at(at)}`,
    along: (axes: ('x' | 'y')[]): string => (axes.length === 2 ? 'in line with two points' : axes[0] === 'x' ? 'above or below a point' : 'level with a point'),
    done: 'Done',
    as: 'As',
    kinds: { pin: 'a pin', slider: 'a slider on a line', slot: 'a pin in a slot', rigid: 'one body' } satisfies Record<JoinKind, string>,
    play: 'Play',
    noPlay: 'none',
    angle: 'Line at',
    place: 'Place',
    placeHint: 'Type x and y and press Enter; with Shift+Enter the place is on the ground.',
    placeWrong: 'two numbers, such as 120, 90',
    recorded: 'Record',
    recordKinds: {
      path: 'the path of a point',
      x: 'the x position of a point',
      y: 'the y position of a point',
      angle: 'the angle of a body',
      angular_velocity: 'the angular velocity of a body',
      force: 'the force in a joint',
    } satisfies Record<RecordKind, string>,
    addPoint: (body: string): string => `Add a point to ${body}`,
    ownPlace: 'own frame, mm',
    points: 'Points',
    rename: 'Name',
    remove: 'Delete',
    removeOf: (what: string): string => `Delete ${what}`,
    question: (what: string, count: number): string => `Delete ${what}? ${count === 1 ? 'One thing goes' : `${count} things go`} with it:`,
    keep: 'Keep it',
    lock: (label: string): string => `Lock ${label} against dragging`,
    dimensions: 'Dimensions',
    inText: 'Show it in the text',
  },

  known: {
    play: 'Play, on the radius',
    playOfDiameter: 'Play, on the diameter',
    tolerance: 'Known as',
    playTerm: 'Radial play',
    noPlay: 'none',
    inText: 'as in the text',
    forms: '0.1 mm: known. 0.1..0.5 mm: unknown between two ends. ±0.02 mm: scatters. H7/g6: a fit.',
    kind: {
      exact: 'Known exactly',
      scatter: 'Random: the distribution is known',
      unknown: 'Unknown: any value in this range',
      none: 'No play: an ideal pin',
    },
    toggle: (label: string): string => `How well is ${label} known?`,
    close: (name: string): string => `Close ${name}`,
    inTheText: 'Show it in the text',
  },

  text: {
    loading: 'Loading the editor …',
    failed: 'The editor could not be loaded.',
    noStudy: 'This model was opened without a study. Open the study in the gallery to edit both.',
    noModel: 'There is no model to show.',
    label: (which: Document): string => `Text of ${which}.toml`,
    tabs: 'Numbers and texts',
    both: 'Both texts',
  },

  problems: {
    heading: 'Problems',
    none: 'No problems.',
    counted(errors: number, warnings: number): string {
      const parts = [];
      if (errors > 0) parts.push(count(errors, 'error', 'errors'));
      if (warnings > 0) parts.push(count(warnings, 'warning', 'warnings'));
      return parts.join(', ') || 'none';
    },
    error: 'Error',
    warning: 'Warning',
    fix: 'Fix',
    explain: 'Explain',
    hide: 'Hide the explanation',
    explaining: 'Loading the explanation …',
    place: (file: string, line: number, column: number): string => `${file}:${line}:${column}`,
    remedies: { join: 'Join two points', link: 'Add a link', motor: 'Place the motor', delete: 'Delete something' } as Partial<Record<EditTool, string>>,
    showAll: 'Show the problems',
    hideAll: 'Hide the problems',
  },

  /** Terms of the studio alone; those of the report stand in its glossary. */
  terms: {
    body: 'A rigid part: a link, a plate or a block. The ground is the body that does not move.',
    joint: 'Connects two bodies: a pin, a slider, or a pin in a slot.',
    drive: 'Prescribes a motion, such as the speed of a crank.',
    loop: 'Links that close on the ground. By the rule of Grashof, a link of a four-bar turns fully where the shortest and the longest link together are at most as long as the other two.',
    force: 'Springs, dampers, forces and torques that act on the bodies. Runs with inertia count them; the band without dynamics does not.',
    output: 'A quantity of interest: the position of a point, the angle of a body, or a force.',
    mobility: 'Degrees of freedom are the independent motions that the joints allow. The motion is determined where there are as many drives.',
    play: 'The radial clearance of a pin: bearing radius minus pin radius. The centre of the pin can be anywhere within it.',
    tolerance: 'How far a dimension may be from its nominal value. The limits are at 3 standard deviations, unless another distribution is written.',
    withoutDynamics: 'Computed without inertia, friction and impacts, to first order in play and tolerances. Runs of the study include them.',
    outerBand: 'The largest first-order effect of all play, plus 2 standard deviations of the dimensions.',
    innerBand: 'Two standard deviations, with every pin anywhere in its clearance and every dimension within its distribution.',
    limit: 'The largest deviation that a requirement of the study allows.',
    contributions: 'Shares of the half width of the band, at the first pose of a requirement or question; without one, at the angle where the band is widest.',
    verdict: 'Met: the required share of mechanisms is within the limits for every value of the unknown inputs, numerical error included. Not met: for at least one value it is not. Undecided: more runs decide. Promised: shown for a stated share of the unknown values.',
  },

  first: {
    heading: 'Three first steps',
    done: 'All three done',
    close: 'Close the first steps',
    isDone: ', done',
    steps: {
      drag: 'Drag a pin: its lengths follow.',
      play: 'Click a pin and type its play: 0.05..0.2 mm',
      band: 'Point at the band below: the deviation at each angle.',
    },
  },

  examples: {
    open: (template: string): string => `Open an example: ${template}`,
  },

  line: {
    tip: 'Drag a pin to change lengths. Click a pin to write its play, a link to see its lengths.',
    /** Names of a file without its signs. */
    plain: (text: string): string => text.replace(/[a-z][a-z0-9]*(?:_[a-z0-9]+)+/g, (name) => name.replaceAll('_', ' ')),
  },

  panes: {
    names: { outline: 'Width of the outline', side: 'Width of numbers and texts', chart: 'Height of the chart', study: 'Height of the second text' } as Record<PaneName, string>,
    hint: 'Drag to resize; a double click resets it',
  },

  runs: {
    none: 'No run yet: Save and run',
    list: (number: number): string => (number === 0 ? 'Runs' : `Runs (${whole.format(number)})`),
  },

  jobs: {
    heading: 'Runs of studies',
    state: { waiting: 'waits', running: 'runs', done: 'done', failed: 'failed', stopped: 'stopped' } as Record<Job['state'], string>,
    runs: (finished: number, most: number): string => `${whole.format(finished)} of at most ${count(most, 'run', 'runs')}`,
    seconds: (seconds: number): string => `${seconds < 10 ? seconds.toFixed(1) : whole.format(seconds)} s`,
    progress: (title: string): string => `Progress of ${title}`,
    cancel: 'Cancel',
    open: 'Open the report',
    whole: 'Show all of it',
    hide: (title: string): string => `Hide the run of ${title}`,
    band: 'Band so far',
    chart: (title: string): string => `Band so far of ${title}`,
    more: (number: number): string => `${count(number, 'more sentence', 'more sentences')}`,
    verdict: (verdict: Verdict): string => `Requirements: ${words.verdict(verdict)}`,
  },

  report: {
    back: 'Back',
    heading: 'Report',
    loading: 'Loading the report …',
    failed: 'The report could not be opened.',
    again: 'Load it again',
    frame: (path: string): string => `Report of ${path}`,
    compare: 'Compare with another result',
    doings: 'Actions for this result',
    witnesses: (number: number): string => `Run ${number === 1 ? 'the mechanism' : `one of ${whole.format(number)} mechanisms`} at which a bound is reached`,
    witnessHint: 'One run in time, with inertia and impacts. Random dimensions have their values in the model.',
    run: 'Run',
    runOf: (values: string): string => `Run the mechanism with ${values}`,
    chosen: (values: string): string => `Chosen in the report: ${values}.`,
    adopt: 'Make it the model',
    noStudy: (title: string): string => `The folder has no study “${title}” for these values.`,
  },

  adopted: (values: string, hasChanged: boolean): string =>
    `Now known exactly: ${values}. Undo reverses this.${hasChanged ? ' The texts have been changed since this result.' : ''}`,

  pick: {
    first: 'Choose result A, then result B.',
    second: 'Choose result B.',
    results: 'Finished studies',
    chosen: 'Result A',
    none: 'No study is finished yet. Choose a mechanism, save and run its study, change a number, and run it again.',
    one: 'One study is finished. Change a number in its study, save and run it: then there are two results to compare.',
    examples: 'Choose a mechanism',
  },

  compare: {
    heading: 'Two results compared',
    choose: 'Results to compare',
    side: (side: string): string => `Result ${side}`,
    none: 'Choose a result',
    swap: 'Swap A and B',
    loading: 'Comparing the results …',
    failed: 'The results cannot be compared.',
    model: (model: string): string => `Model ${model}`,
    reportOf: (side: string): string => `Report of ${side}`,
    bands: 'Bands',
    chartOf: (title: string): string => `Chart: ${title}, both bands`,
    pointAt: 'Point at a chart, or use the arrow keys in it, to read both bands at one angle.',
    reaches: (angle: number, a: string, b: string): string => `At ${whole.format(angle)}°: A from ${a}, B from ${b}.`,
    requirements: 'Requirements',
    what: 'Requirement on',
    kept: (share: string): string => `${share} of mechanisms`,
    required: (limits: string): string => `required: ${limits}`,
    notRequired: 'not required',
    statistics: 'Statistics',
    statisticsHint:
      'Smallest and largest value found over all unknown values, each with its numerical error. The difference is B minus A of the values found.',
    statistic: 'Statistic',
    end: 'Bound',
    lower: 'lower',
    upper: 'upper',
    difference: 'B − A',
    weightOf: 'Against both errors',
    weight: { none: 'no difference', within_errors: 'within the errors', beyond_errors: 'larger' },
    inputs: 'Inputs that differ',
    noInputs: 'No input differs.',
    input: 'Input',
    place: 'Where',
    places: { uncertain: 'uncertain', model: 'model', study: 'study', table: 'table', command: 'command' },
    notThere: 'not there',
    leftOut: 'Not compared',
  },

  shelf: {
    reading: 'Reading …',
    notRun: { study: 'not run yet', model: 'a model without a study' } as Record<Document, string>,
    noVerdict: (texts: TextState): string => (texts === 'same' ? 'result without requirements' : `result without requirements, ${words.shelf.texts[texts]}`),
    texts: { same: '', changed: 'the text has changed since', unknown: 'the result does not hold its texts' } as Record<TextState, string>,
    all: (number: number): string => `Show all ${whole.format(number)}`,
    duplicate: 'Duplicate',
    duplicateOf: (title: string): string => `Duplicate ${title}`,
    remove: 'Delete',
    removeOf: (title: string): string => `Delete ${title}`,
    removed: (title: string, entry: string): string => `${title} was deleted. It is in .trash/${entry}.`,
    undo: 'Undo',
    draft: (template: string): string => `Template ${template}`,
    blank: 'New drawing',
    notSavedYet: 'not saved yet',
  },
};
