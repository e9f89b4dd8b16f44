// All strings of the front end: whole sentences, with named holes. Words of the server are shown as they come.
import type { Hold } from './sketch.svelte.ts';
import type { Job, JointEntry, ResultEntry, Verdict, Which } from './messages.ts';

const whole = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });
const relative = new Intl.RelativeTimeFormat('en', { numeric: 'auto' });

function count(number: number, one: string, many: string): string {
  return whole.format(number) + ' ' + (number === 1 ? one : many);
}

export const tools = ['link', 'plate', 'ground', 'slider', 'motor', 'delete'] as const;
export type Tool = (typeof tools)[number];

export const words = {
  studio: 'loosepin studio',
  fileName: (which: Which): string => which + '.toml',
  percent: (share: number): string => whole.format(share * 100) + ' %',
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
    const names: Record<Verdict, string> = { met: 'met', 'not met': 'not met', undecided: 'undecided', promised: 'promised' };
    return names[verdict];
  },

  wire: {
    lost: (seconds: number): string =>
      `The connection to loosepin is lost. It is tried again after ${count(seconds, 'second', 'seconds')}. What you have typed is kept.`,
    refusedTitle: 'This page has no key to the studio',
    refused: 'Open the address that `loosepin serve` printed. It has the key at its end; the key is kept until this tab is closed.',
    unreachable: 'loosepin does not answer. It may have been stopped: start `loosepin serve` again.',
    unknown: 'loosepin answered with an error that it did not explain.',
    close: 'Close this message',
  },

  keys: {
    title: 'Keys',
    list: [
      ['Space', 'plays or stops the drawing'],
      ['Arrows', 'on a pin of the drawing: move it by one step, with Shift by ten'],
      ['Alt', 'while a pin is dragged: values that are not round'],
      ['Escape', 'ends a drag without a change'],
      ['[ and ]', 'turn the drive by 1 degree'],
      ['Ctrl+S', 'saves'],
      ['Ctrl+Z, Ctrl+Shift+Z', 'undo and redo, over both texts'],
      ['Up and Down', 'in a number: one step; with Shift ten steps, with Alt a tenth'],
      ['/', 'finds a mechanism in the gallery'],
      ['F8', 'in a text: goes to the next problem'],
    ] as [string, string][],
    single: 'Use the keys Space, [, ] and /',
  },

  gallery: {
    heading: 'Mechanisms',
    folder: (folder: string): string => `Folder ${folder}`,
    find: 'Find',
    findHint: 'Name of a study, a model or a mechanism',
    continue: 'Continue',
    draw: 'Draw from nothing',
    import: 'Import a drawing (DXF)',
    unit: 'Unit',
    ownUnit: 'of the drawing',
    start: 'Start from a mechanism',
    startHint: 'A click makes a new folder with a model and a study.',
    results: 'Results',
    compare: 'Compare two results',
    loading: 'The folder is read …',
    none: 'There are no models in this folder yet. Start from a mechanism below.',
    noneFound: (text: string): string => `Nothing here is called “${text}”.`,
    noTemplates: 'There are no templates.',
    truncated: 'The folder holds more than is shown here. Use the search, or serve a smaller folder.',
    withModel: (path: string): string => `with ${path}`,
    kind: { study: 'Study', model: 'Model' } as Record<Which, string>,
    resultKind: { study: 'Study', simulation: 'Simulation', motion: 'Motion', sweep: 'Sweep' } as Record<ResultEntry['kind'], string>,
    openReport: 'Report',
    openReportOf: (title: string): string => `Report of ${title}`,
    allResults: (number: number): string => `Show all ${whole.format(number)} results`,
    moving: 'Move the drawings',
    noDrawing: 'no drawing',
    making: (name: string): string => `The folder ${name} is made …`,
    failed: 'The folder could not be read.',
    importFailed: 'The drawing was not imported:',
    tooLarge: 'It has more than 4 MiB. Save the lines and circles of the mechanism alone.',
    imported: (notes: string[]): string => `Imported: ${notes.join('; ')}. Fill in every "?": see the problems below.`,
    again: 'Try again',
  },

  editor: {
    back: 'Gallery',
    loading: 'The texts are read …',
    failed: 'The texts could not be opened.',
    unsaved: 'unsaved',
    saved: 'saved',
    undo: 'Undo',
    redo: 'Redo',
    save: 'Save',
    saving: 'Saving …',
    saveAndRun: 'Save and run',
    noStudy: 'Only a study can be run, and this model was opened without one.',
    noModel: 'The study does not name a model that can be read. Correct the line `model = …`, save, and open it again.',
    leaveQuestion: 'The texts have changes that are not saved.',
    saveAndLeave: 'Save and leave',
    leaveWithout: 'Leave without saving',
    stay: 'Stay',
    changed: (path: string): string => `${path} was changed on disk by another program.`,
    load: 'Load what is on disk',
    keep: 'Keep mine and overwrite',
    saveFailed: (message: string): string => `The texts could not be saved. ${message}`,
    notAdopted: (message: string): string => `The values of the result are not taken over. ${message}`,
    runNeedsConnection: 'The study was saved but not started, since the connection is lost.',
  },

  outline: {
    heading: 'Outline',
    bodies: 'Bodies',
    joints: 'Joints',
    drives: 'Drives',
    outputs: 'Outputs',
    none: 'none',
    noPlay: 'no play',
    play: (play: string): string => `play ${play.replace(/^c = /, '')}`,
    goTo: (name: string): string => `Show ${name} in the text`,
    empty: 'The outline appears when the model can be read.',
  },

  drawing: {
    heading: 'Drawing',
    pin: (joint: JointEntry): string => `${joint.name}, ${joint.kind}${joint.play === null ? '' : ', ' + joint.play}. Drag it, or move it with the arrow keys.`,
    stale: 'The drawing is that of the last text that could be read.',
    cut: 'The analysis of these texts took longer than 2 s and was stopped. What is shown is of the texts before.',
    coarse: 'At more positions the analysis took longer than 2 s and was stopped.',
    tooLarge: 'There is no drawing: the analysis of these texts took longer than 2 s and was stopped.',
    none: 'There is no drawing: the model cannot be read yet. See the problems below.',
    still: 'The model can be read, but there is no drawing of it.',
    loading: 'The drawing is made …',
    play: 'Play',
    pause: 'Pause',
    angle: 'Drive angle',
    back: 'Turn back by 1 degree',
    forth: 'Turn on by 1 degree',
  },

  band: {
    limit: (written: string): string => `Limit ±${written}. Drag it, or move it with the arrow keys.`,
    addLimit: 'Add a limit',
    heading: 'Deviation over one turn, without dynamics',
    output: 'Output',
    chart: 'Chart of the band',
    none: 'No output has a deviation: add play to a joint, or scatter to a number.',
    hover: 'Point at the chart to move the mechanism.',
    parts: 'Which tolerance and which play make the band',
    sentences: 'All outputs, in sentences',
    play: 'play',
    part: 'tolerance',
  },

  numbers: {
    tab: 'Numbers',
    find: 'Find a number',
    none: 'Numbers appear when the model can be read.',
    noneFound: (text: string): string => `No number is called “${text}”.`,
    scrub: 'Drag sideways to change',
    groups: {
      parameter: 'Parameters',
      joint: 'Joints',
      drive: 'Drives',
      scatter: 'Scatter, as the study has it',
      unknown: 'Unknown, as the study has it',
      body: 'Bodies',
      contact: 'Contacts',
      other: 'Other numbers',
    } as Record<string, string>,
    lower: 'lower end',
    upper: 'upper end',
    goTo: (label: string): string => `Show ${label} in the text`,
  },

  draw: {
    heading: 'Draw a mechanism',
    back: '← Gallery',
    name: 'Name',
    firstName: 'drawn',
    undo: 'Undo',
    redo: 'Redo',
    make: 'Make it move',
    tools: 'Tools',
    canvas: 'Drawing, 10 mm a square',
    names: { link: 'Link', plate: 'Plate', ground: 'Ground', slider: 'Slider', motor: 'Motor', delete: 'Delete' } as Record<Tool, string>,
    keys: { link: 'l', plate: 'p', ground: 'g', slider: 's', motor: 'm', delete: 'd' } as Record<Tool, string>,
    linkStart: 'Click where a link begins: a pin, or a free place. With Shift the pin stands on the ground.',
    linkEnd: (pin: string): string => `The link begins at ${pin}. Click where it ends; a click on a pin joins it.`,
    plateNext: 'Click places or pins that belong to the plate. Escape ends it.',
    hints: {
      link: '',
      plate: 'Click a link: it becomes a plate with further pins.',
      ground: 'Click a pin: it stands on the ground, or is free again.',
      slider: 'Click a pin: it is a block in a horizontal guide; once more: in a vertical one; then free.',
      motor: 'Click a pin on the ground: the motor turns the link at it.',
      delete: 'Click a pin or a link: it goes.',
    } as Record<Tool, string>,
    begin: 'A mechanism needs pins on the ground, links between pins, and a motor.',
    ready: 'Masses, speed and tolerances are first guesses, marked so in the text.',
    at: (x: number, y: number): string => `${x}, ${y} mm`,
    pin: (name: string, hold: Hold, isMotor: boolean): string =>
      `${name}, ${hold.kind === 'free' ? 'free' : hold.kind === 'ground' ? 'on the ground' : `block in a guide at ${hold.angle_deg}°`}${isMotor ? ', with the motor' : ''}`,
    larger: 'Larger',
    smaller: 'Smaller',
    lists: 'Pins and links as lists',
    pins: 'Pins',
    links: 'Links',
    holds: { free: 'free', ground: 'on the ground', slider: 'block in a guide' } as Record<Hold['kind'], string>,
    heldBy: (name: string): string => `What holds ${name}`,
    angle: 'at',
    remove: (name: string): string => `Remove ${name}`,
    addPin: 'Add a pin',
    addTo: (link: string): string => `Add a pin to ${link}`,
    addToLink: 'add a pin …',
    addLink: 'Add a link',
    ends: ['From', 'To'],
  },

  known: {
    play: 'Play, on the radius',
    playOfDiameter: 'Play, on the diameter',
    tolerance: 'Known as',
    noPlay: 'none',
    inText: 'as the text says',
    forms: '0.1 mm: known. 0.1..0.5 mm: unknown between two ends. ±0.02 mm: scatters. H7/g6: a fit.',
    kind: {
      exact: 'Known exactly',
      scatter: 'Scatters: the shop knows how',
      unknown: 'Unknown: anything that this allows',
      none: 'No play: an ideal pin',
    },
    toggle: (label: string): string => `How well is ${label} known?`,
    close: (name: string): string => `Close ${name}`,
    inTheText: 'Show it in the text',
  },

  text: {
    loading: 'The editor is loaded …',
    failed: 'The editor could not be loaded.',
    noStudy: 'This model was opened without a study. Open the study in the gallery to edit both.',
    noModel: 'There is no model to show.',
    label: (which: Which): string => `Text of ${which}.toml`,
    tabs: 'Numbers and texts',
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
    explaining: 'The explanation is fetched …',
    place: (file: string, line: number, column: number): string => `${file}:${line}:${column}`,
    showAll: 'Show the problems',
    hideAll: 'Hide the problems',
  },

  jobs: {
    heading: 'Runs of studies',
    state: { waiting: 'waits', running: 'runs', done: 'done', failed: 'failed', stopped: 'stopped' } as Record<Job['state'], string>,
    runs: (finished: number, most: number): string => `${whole.format(finished)} of at most ${count(most, 'run', 'runs')}`,
    seconds: (seconds: number): string => `${seconds < 10 ? seconds.toFixed(1) : whole.format(seconds)} s`,
    progress: (title: string): string => `Progress of ${title}`,
    cancel: 'Cancel',
    open: 'Open the report',
    hide: (title: string): string => `Hide the run of ${title}`,
    more: (number: number): string => `${count(number, 'more sentence', 'more sentences')}`,
    verdict: (verdict: Verdict): string => `Requirements: ${words.verdict(verdict)}`,
  },

  report: {
    back: 'Back',
    heading: 'Report',
    loading: 'The report is fetched …',
    failed: 'The report could not be opened.',
    again: 'Fetch it again',
    frame: (path: string): string => `Report of ${path}`,
    compare: 'Compare with another result',
    doings: 'What can be done with this result',
    witnesses: (number: number): string => `Run ${number === 1 ? 'the mechanism' : `one of ${whole.format(number)} mechanisms`} at which a bound is reached`,
    witnessHint: 'One run in time, with inertia and impacts. Parts that scatter have the dimensions of the model.',
    run: 'Run',
    runOf: (values: string): string => `Run the mechanism with ${values}`,
    chosen: (values: string): string => `Chosen in the report: ${values}.`,
    adopt: 'Make it the model',
    noStudy: (title: string): string => `The folder has no study “${title}” to take it over.`,
  },

  adopted: (values: string, hasChanged: boolean): string =>
    `Known exactly now: ${values}. Undo takes it back.${hasChanged ? ' The texts are not those of the result: they have been changed since.' : ''}`,

  compare: {
    heading: 'Two results compared',
    choose: 'Results to compare',
    side: (side: string): string => `Result ${side}`,
    none: 'Choose a result',
    swap: 'Swap A and B',
    tooFew: 'Two finished studies are needed: run one with other numbers.',
    loading: 'The results are compared …',
    failed: 'The results cannot be compared.',
    model: (model: string): string => `Model ${model}`,
    reportOf: (side: string): string => `Report of ${side}`,
    bands: 'Bands',
    chartOf: (title: string): string => `Chart: ${title}, both bands`,
    requirements: 'Requirements',
    what: 'Requirement on',
    kept: (share: string): string => `${share} of mechanisms`,
    required: (limits: string): string => `required: ${limits}`,
    notRequired: 'not required',
    statistics: 'Statistics',
    statisticsHint: 'Bounds over all unknown values, numerical error included. The difference is B minus A of the values found.',
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
};
