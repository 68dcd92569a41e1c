// The view Set up: what the robot needs before it drives, and how well the link and the loop do.
import { DoctorPanel } from '../panel/doctor_panel.ts';
import { h } from '../panel/dom.ts';
import { Histogram } from '../panel/histogram.ts';
import { IdentifyPanel } from '../panel/identify_panel.ts';
import { LinkTable } from '../panel/link_table.ts';
import { ParameterPanel } from '../panel/parameter_panel.ts';
import { Tabs } from '../panel/tabs.ts';
import type { Daemon } from './daemon.ts';
import { keyList } from './keys.ts';

export class SetupView {
  readonly tabs: Tabs;

  constructor(daemon: Daemon) {
    const { live, call, consent } = daemon;
    const doctor = new DoctorPanel(call, consent);
    const identify = new IdentifyPanel(call, consent);
    const parameters = new ParameterPanel((name, value) => { daemon.setParameter(name, value); }, call);
    const links = new LinkTable();
    const histogram = new Histogram();
    this.tabs = new Tabs('setup', 'Set up', [
      { id: 'doctor', title: 'Doctor', element: doctor.element, show: () => { doctor.show(live, daemon.connected, daemon.mayCommand); } },
      { id: 'identify', title: 'Identify', element: identify.element, show: () => { identify.show(live, daemon.connected, daemon.mayCommand); } },
      { id: 'parameters', title: 'Parameters', element: parameters.element, show: () => { parameters.show(live, daemon.connected, daemon.mayCommand); } },
      {
        id: 'link',
        title: 'Link',
        element: h('div', { class: 'link-page', tabindex: '0' }, links.element, histogram.element),
        show: () => {
          links.show(live);
          histogram.show(live);
        },
      },
      { id: 'keys', title: 'Keys', element: keyList(), show: () => undefined },
    ]);
  }

  /** While this view is shown. */
  needs(topic: string): boolean {
    return this.tabs.selected === 'link' && (topic === '/loop' || topic === '/client');
  }
}
