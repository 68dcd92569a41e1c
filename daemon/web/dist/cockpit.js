var gl=class{constructor(e,t,n,s){this.call=e;this.inputs=t;this.attended=n;this.ended=s}call;inputs;attended;ended;share=.5;limits={speed_mps:.2,yaw_rate_radps:1};wish;token;taking=!1;wasDriven=!1;unanswered=0;get drives(){return this.token!==void 0}async take(){if(!(this.drives||this.taking)){this.taking=!0,this.inputs.clear();try{let e=await this.call("drive_take",{});if(typeof e?.token!="string")throw new Error("the daemon gave no token");this.token=e.token,this.wasDriven=!1,this.unanswered=0}catch(e){this.ended(e instanceof Error?e.message:String(e))}finally{this.taking=!1}}}release(){let e=this.token;e!==void 0&&(this.forget(),this.call("drive_release",{token:e}).catch(()=>{}),this.ended(""))}lose(e){this.drives&&(this.forget(),this.ended(e))}leave(){this.inputs.clear(),this.drives&&this.send(this.inputs.wish())}received(e){this.drives&&(e.run==="driving"?this.wasDriven=!0:this.wasDriven&&this.lose(e.run==="idle"?"the robot was disarmed":`the drive is over: ${e.run}`))}tick(){!this.drives||!this.attended()||this.send(this.inputs.wish())}send(e){let t=this.token;if(this.wish=e,this.unanswered>=5)return;++this.unanswered;let n={token:t,speed_mps:e.forward*this.share*this.limits.speed_mps,yaw_rate_radps:e.left*this.share*this.limits.yaw_rate_radps,input_ms:e.at_ms};this.call("drive",n).then(()=>{this.unanswered=Math.max(0,this.unanswered-1)},s=>{t===this.token&&this.lose(s instanceof Error?s.message:String(s))})}forget(){this.token=void 0,this.wish=void 0,this.inputs.clear()}};var Gu={ArrowUp:{forward:1,left:0},KeyW:{forward:1,left:0},ArrowDown:{forward:-1,left:0},KeyS:{forward:-1,left:0},ArrowLeft:{forward:0,left:1},KeyA:{forward:0,left:1},ArrowRight:{forward:0,left:-1},KeyD:{forward:0,left:-1}},kx=150,Vu=.12,Bx=.9;function zx(i){return i in Gu}function _l(i){return Math.max(-1,Math.min(1,i))}function $p(i){let e=Math.abs(i);return e>Vu?Math.sign(i)*Math.min(1,(e-Vu)/(Bx-Vu)):0}var xl=class{constructor(e,t){this.pads=e;this.now=t}pads;now;frozen=!1;held=new Set;stick;padValues="";padChanged_ms=-1/0;key(e,t){return zx(e)?(t?this.held.add(e):this.held.delete(e),!0):!1}touch(e){this.stick=e}clear(){this.held.clear(),this.stick=void 0,this.frozen=!1,this.padChanged_ms=-1/0}wish(){let e=this.now(),t=this.pad(e);if(this.stick!==void 0)return{forward:_l(this.stick.forward),left:_l(this.stick.left),source:"stick",at_ms:e};if(this.held.size>0){let n=0,s=0;for(let r of this.held)n+=Gu[r]?.forward??0,s+=Gu[r]?.left??0;return{forward:_l(n),left:_l(s),source:"keys",at_ms:e}}return t??{forward:0,left:0,source:"none",at_ms:e}}pad(e){let t=this.pads().find(o=>o?.connected===!0&&o.axes.length>=2),n=t?`${String(t.timestamp)} ${t.axes.join(" ")}`:"";if(n!==this.padValues&&this.padValues!==""&&(this.padChanged_ms=e),this.padValues=n,this.frozen=!1,!t)return;let s=$p(-(t.axes[1]??0)),r=$p(-(t.axes[0]??0));if(!(s===0&&r===0))return this.frozen=e-this.padChanged_ms>kx,this.frozen?{forward:0,left:0,source:"gamepad",at_ms:e}:{forward:s,left:r,source:"gamepad",at_ms:this.padChanged_ms}}};var Kp=["foxglove.sdk.v1","foxglove.websocket.v1"],Wu=i=>typeof i=="object"&&i!==null&&!Array.isArray(i),vl=i=>Number.isSafeInteger(i)&&i>=0,Pi=i=>typeof i=="string"?i:"",Hu=i=>Array.isArray(i)?i.filter(Wu):[],Zp=i=>Array.isArray(i)?i.filter(vl):[];function Jp(i){let e;try{e=JSON.parse(i)}catch{return}if(Wu(e))switch(e.op){case"serverInfo":return{op:"serverInfo",name:Pi(e.name),sessionId:Pi(e.sessionId),capabilities:Array.isArray(e.capabilities)?e.capabilities.map(Pi):[],metadata:Wu(e.metadata)?Object.fromEntries(Object.entries(e.metadata).map(([t,n])=>[t,Pi(n)])):{}};case"advertise":return{op:"advertise",channels:Hu(e.channels).filter(t=>vl(t.id)).map(t=>({id:t.id,topic:Pi(t.topic),encoding:Pi(t.encoding),schemaName:Pi(t.schemaName)}))};case"unadvertise":return{op:"unadvertise",channelIds:Zp(e.channelIds)};case"advertiseServices":return{op:"advertiseServices",services:Hu(e.services).filter(t=>vl(t.id)).map(t=>({id:t.id,name:Pi(t.name)}))};case"unadvertiseServices":return{op:"unadvertiseServices",serviceIds:Zp(e.serviceIds)};case"parameterValues":return{op:"parameterValues",parameters:Hu(e.parameters).filter(t=>typeof t.name=="string").map(t=>({name:Pi(t.name),value:t.value})),id:typeof e.id=="string"?e.id:void 0};case"serviceCallFailure":return vl(e.callId)?{op:"serviceCallFailure",callId:e.callId,message:Pi(e.message)}:void 0;case"status":return{op:"status",level:Number(e.level)||0,message:Pi(e.message)};default:return}}function jp(i){let e=new DataView(i);if(!(e.byteLength<1))switch(e.getUint8(0)){case 1:return e.byteLength<13?void 0:{op:"message",subscriptionId:e.getUint32(1,!0),time_s:Number(e.getBigUint64(5,!0))*1e-9,payload:new Uint8Array(i,13)};case 2:return e.byteLength<9?void 0:{op:"time",time_s:Number(e.getBigUint64(1,!0))*1e-9};case 3:{if(e.byteLength<13)return;let t=e.getUint32(9,!0);return t>e.byteLength-13?void 0:{op:"serviceResponse",serviceId:e.getUint32(1,!0),callId:e.getUint32(5,!0),encoding:new TextDecoder().decode(new Uint8Array(i,13,t)),payload:new Uint8Array(i,13+t)}}default:return}}function Qp(i){return JSON.stringify({op:"subscribe",subscriptions:i})}function em(i){return JSON.stringify({op:"unsubscribe",subscriptionIds:i})}function tm(i,e,t){return JSON.stringify({op:"setParameters",parameters:[{name:i,value:e}],id:t})}function nm(i,e,t){let n=new TextEncoder().encode("json"),s=new TextEncoder().encode(JSON.stringify(t)),r=new ArrayBuffer(13+n.length+s.length),o=new DataView(r);return o.setUint8(0,2),o.setUint32(1,i,!0),o.setUint32(5,e,!0),o.setUint32(9,n.length,!0),new Uint8Array(r,13).set(n),new Uint8Array(r,13+n.length).set(s),r}var yl=class{constructor(e,t,n=()=>performance.now()){this.make=e;this.events=t;this.now=n;this.watched_ms=this.now(),setInterval(()=>{this.watch()},500),this.open()}make;events;now;socket;isOpen=!1;silent_ms=0;watched_ms=0;retry_ms=200;retryTimer;get connected(){return this.isOpen}send(e){return!this.isOpen||this.socket===void 0?!1:(this.socket.send(e),!0)}retryNow(){this.retryTimer!==void 0&&(clearTimeout(this.retryTimer),this.open())}open(){this.retryTimer=void 0;let e=this.make();this.socket=e,this.silent_ms=0,e.onopen=()=>{this.isOpen=!0,this.silent_ms=0,this.retry_ms=200,this.events.opened()},e.onmessage=t=>{let n=t.data;this.silent_ms=0,typeof n=="string"?this.events.text(n):n instanceof ArrayBuffer&&this.events.binary(n)},e.onclose=()=>{this.drop()}}watch(){let e=this.now();this.silent_ms+=Math.min(e-this.watched_ms,500),this.watched_ms=e,this.socket!==void 0&&this.silent_ms>(this.isOpen?3e3:1e4)&&this.drop()}drop(){let e=this.socket;if(e===void 0)return;e.onopen=e.onclose=e.onmessage=null,e.close(),this.socket=void 0,this.isOpen=!1;let t=this.retry_ms;this.retry_ms=Math.min(2*t,2e3),this.events.closed(t),this.retryTimer=setTimeout(()=>{this.open()},t)}};var bl=class{constructor(e,t,n){this.events=t;this.connection=new yl(e,{opened:()=>{},closed:s=>{this.forget(),t.closed(s)},text:s=>{this.text(s)},binary:s=>{this.binary(s)}},n)}events;connection;listeners=new Map;channels=new Map;services=new Map;subscriptions=new Map;subscribed=new Map;calls=new Map;decoder=new TextDecoder;isReady=!1;nextSubscription=1;nextCall=1;get ready(){return this.isReady&&this.connection.connected}subscribe(e,t){this.listeners.set(e,t),this.subscribeNow([e])}unsubscribe(e){this.listeners.delete(e);let t=this.subscribed.get(e);t!==void 0&&(this.subscribed.delete(e),this.subscriptions.delete(t),this.connection.send(em([t])))}call(e,t={}){let n=this.services.get(e);if(!this.ready)return Promise.reject(new Error("not connected"));if(n===void 0)return Promise.reject(new Error(`the server has no service "${e}"`));let s=this.nextCall++;return new Promise((r,o)=>{this.calls.set(s,{resolve:r,reject:o}),this.connection.send(nm(n,s,t))})}setParameter(e,t){return this.connection.send(tm(e,t,`set ${e}`))}retryNow(){this.connection.retryNow()}text(e){let t=Jp(e);switch(t?.op){case"serverInfo":this.events.serverInfo({sessionId:t.sessionId,metadata:t.metadata});break;case"advertise":for(let{id:n,topic:s}of t.channels)this.channels.set(s,n);this.isReady&&this.subscribeNow([...this.listeners.keys()]);break;case"unadvertise":for(let[n,s]of[...this.channels])t.channelIds.includes(s)&&this.channels.delete(n);break;case"advertiseServices":for(let{id:n,name:s}of t.services)this.services.set(s,n);if(this.isReady)break;this.isReady=!0,this.events.ready(),this.subscribeNow([...this.listeners.keys()]);break;case"unadvertiseServices":for(let[n,s]of[...this.services])t.serviceIds.includes(s)&&this.services.delete(n);break;case"parameterValues":this.events.parameters(t.parameters);break;case"serviceCallFailure":this.settle(t.callId)?.reject(new Error(t.message));break;case"status":this.events.status(t.level,t.message);break;case void 0:break}}binary(e){let t=jp(e);if(t?.op==="message"){let n=this.subscriptions.get(t.subscriptionId);if(n===void 0)return;let s=this.json(t.payload);s!==void 0&&n(s,t.time_s)}else t?.op==="serviceResponse"&&this.settle(t.callId)?.resolve(this.json(t.payload))}json(e){try{return JSON.parse(this.decoder.decode(e))}catch{return}}subscribeNow(e){if(!this.ready)return;let t=[];for(let n of e){let s=this.channels.get(n),r=this.listeners.get(n);if(s===void 0||r===void 0||this.subscribed.has(n))continue;let o=this.nextSubscription++;this.subscriptions.set(o,r),this.subscribed.set(n,o),t.push({id:o,channelId:s})}t.length>0&&this.connection.send(Qp(t))}settle(e){let t=this.calls.get(e);return this.calls.delete(e),t}forget(){this.isReady=!1,this.channels.clear(),this.services.clear(),this.subscriptions.clear(),this.subscribed.clear();let e=[...this.calls.values()];this.calls.clear();for(let t of e)t.reject(new Error("connection lost"))}};var Gs=i=>i!=null&&Number.isFinite(i);function dt(i,e){if(!Gs(i))return"–";let t=Math.abs(i).toFixed(e);return i<0&&Number(t)!==0?"−"+t:t}function Qi(i,e){return dt(Gs(i)?i*180/Math.PI:null,e)}function im(i,e){return dt(Gs(i)?i*1e3:null,e)}function Xu(i,e){return dt(Gs(i)?i*100:null,e)}function Ht(i){return Gs(i)?i>0&&i<.95?`${i.toFixed(1)} µs`:i<1e3?`${i.toFixed(0)} µs`:i<1e4?`${(i/1e3).toFixed(1)} ms`:i<1e6?`${(i/1e3).toFixed(0)} ms`:`${(i/1e6).toFixed(1)} s`:"–"}function Ii(i){if(!Gs(i)||i<0)return"–";let e=Math.floor(i*10+1e-6),t=Math.floor(e/10),n=s=>String(s).padStart(2,"0");return t>=3600?`${Math.floor(t/3600)}:${n(Math.floor(t/60)%60)}:${n(t%60)}`:`${Math.floor(t/60)}:${n(t%60)}.${e%10}`}function Hs(i){if(!Gs(i))return"–";let e=["B","kB","MB","GB"],t=0,n=i;for(;n>=1e3&&t<e.length-1;)n/=1e3,t++;return`${n.toFixed(t===0||n>=100?0:1)} ${e[t]??""}`}function Rn(i){return Gs(i)?Math.round(i).toString().replace(/\B(?=(\d{3})+$)/g," "):"–"}function G(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))n.setAttribute(s,r);return n.append(...t),n}function et(i,e){i.textContent!==e&&(i.textContent=e)}function nn(i,e,t){i.classList.contains(e)!==t&&i.classList.toggle(e,t)}function yt(i,e,t){i.getAttribute(e)!==t&&i.setAttribute(e,t)}function es(i){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 16 16"),e.setAttribute("aria-hidden","true"),e.classList.add("icon");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",Gx[i]),e.append(t),e}var Gx={play:"M4 2.5v11l9-5.5z",pause:"M4 3h3v10H4zM9 3h3v10H9z",record:"M8 3.5a4.5 4.5 0 1 0 0 9 4.5 4.5 0 0 0 0-9z",wheel:"M8 1.5a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 0 1 4.3 3.2L9.6 7a1.8 1.8 0 0 0-3.2 0l-2.7-.3A4.5 4.5 0 0 1 8 3.5zM7 12.4A4.5 4.5 0 0 1 3.6 8.7l2.6.4.8 1zm2 0v-2.3l.8-1 2.6-.4A4.5 4.5 0 0 1 9 12.4z",square:"M4 4h8v8H4z",close:"M4 5l1-1 3 3 3-3 1 1-3 3 3 3-1 1-3-3-3 3-1-1 3-3z",stop:"M5.3 1.5h5.4l3.8 3.8v5.4l-3.8 3.8H5.3l-3.8-3.8V5.3z"};var Sl=class{element=G("div",{class:"question",role:"dialog","aria-labelledby":"question-text",hidden:""});text=G("p",{id:"question-text"});first;constructor(e){let t=(n,s,r)=>{let o=G("button",{type:"button",class:"control",id:n},s);return o.addEventListener("click",()=>{this.close(),r()}),o};this.first=t("start-cancel","Cancel",()=>{}),this.element.append(this.text,this.first,t("start-placed","Placed back at the start: start there",()=>{e("start")}),t("start-here","Go on from here",()=>{e("here")}))}get open(){return!this.element.hidden}ask(e){this.element.hidden=!1,this.show(e,!0),this.first.focus()}close(){this.element.hidden=!0}show(e,t){if(!this.open)return;let n=e?.go_on_from;if(n===void 0||!t){this.close();return}let s=`x ${dt(n.x_m,2)} m, y ${dt(n.y_m,2)} m, yaw ${Qi(n.yaw_rad,0)}°`,r=`${dt(e?.progress_m,2)} of ${dt(e?.length_m,2)} m along the course`;et(this.text,`The last run ended on its way. The robot is believed to be at ${s}, ${r}. Where is it now?`)}};var Hx=3e3,Wx="This daemon takes no commands from here but STOP (server.commands)",Ml=class{constructor(e,t,n=()=>performance.now()){this.send=e;this.sendStart=t;this.now=n;this.question=new Sl(this.sendStart),this.element.append(this.start.button,this.hold.button,this.record.button,this.question.element),this.start.button.addEventListener("click",()=>{this.pressStart()}),this.hold.button.addEventListener("click",()=>{this.pressHold()}),this.record.button.addEventListener("click",()=>{this.send(this.recording?"record_stop":"record_start")})}send;sendStart;now;element=G("div",{class:"controls",role:"group","aria-label":"Run"});start=qu("start","play","Start","r");hold=qu("hold","pause","Hold","h");record=qu("record","record","Record","");question;confirmUntil_ms=0;state;needsConfirmation=!0;recording=!1;pressStart(){if(this.start.button.disabled||this.question.open)return;if(this.state?.go_on_from!==void 0){this.question.ask(this.state);return}let e=this.now();if(this.needsConfirmation&&e>this.confirmUntil_ms){this.confirmUntil_ms=e+Hx;return}this.confirmUntil_ms=0,this.sendStart("start")}pressHold(){this.hold.button.disabled||this.send("hold")}forget(){this.question.close(),this.confirmUntil_ms=0}show(e,t,n){let s=e.get("/state"),r=t&&n&&s!==void 0&&!e.stale("/state");this.needsConfirmation=s?.confirm_start!==!1;let o=this.now()<this.confirmUntil_ms,a=r&&s.can.start;this.start.button.disabled=!a,this.state=s,this.question.show(s,a),nn(this.start.button,"confirm",o),et(this.start.label,o?"Press again":"Start");let l=n?s?.why_not_start??"":Wx;yt(this.start.button,"title",l===""?"Start the course (r)":l),this.hold.button.disabled=!(r&&s.can.hold);let c=e.get("/recording");this.recording=c?.active===!0,this.record.button.disabled=!(r&&(s.can.record||this.recording)),nn(this.record.button,"active",this.recording),et(this.record.label,this.recording?Ii(c?.elapsed_s):"Record");let h=c?.available===!1?"No directory to record to: start tp100d with --record DIR":"",d=this.recording?`${c?.run??""}, ${Hs(c?.bytes)}`:h;yt(this.record.button,"title",c?.warning===""||c===void 0?d:c.warning),nn(this.record.button,"warn",(c?.warning??"")!=="")}};function qu(i,e,t,n){let s=G("span",{class:"button-label"},t),r=G("button",{type:"button",id:i,class:"control"},es(e),s);return n!==""&&r.setAttribute("aria-keyshortcuts",n),{button:r,label:s}}function sm(i){return/^\s*\[(model|shape|drive|emulated)\b/m.test(i)&&!/^\s*\[\[segment\]\]/m.test(i)?"robot":"course"}function rm(i){return i.replace(/\.toml$/i,"").replace(/[^A-Za-z0-9._-]+/g,"-").replace(/^[.-]+/,"").slice(0,64)}function om(i){let e=(t,n)=>t===void 0||t===0?[]:[`${t} ${n}${t===1?"":"s"}`];return i.length_m===void 0?"":[`${i.length_m.toFixed(2)} m`,...i.duration_s===void 0?[]:[`${i.duration_s.toFixed(0)} s`],...e(i.ramps?.length,"ramp"),...e(i.blocks?.length,"block"),...e(i.surfaces?.length,"surface"),...e(i.disturbances,"disturbance")].join(" · ")}function Yu(i){let e=i.height_m/Math.tan(i.up_rad),t=i.height_m/Math.tan(i.down_rad),n=(e+i.top_m+t)/2;return[{x:-n,y:0},{x:n,y:0},{x:n-t,y:i.height_m},{x:-n+e,y:i.height_m}]}function cm(i){let e=i.depth_m/2;return[{x:-e,y:0},{x:e,y:0},{x:e,y:i.height_m},{x:-e,y:i.height_m}]}function wl(i,e,t=12){let n=[];for(let[s,r]of[[i/2,-Math.PI/2],[-i/2,Math.PI/2]])for(let o=0;o<=t;o++){let a=r+Math.PI*o/t;n.push({x:s+e*Math.cos(a),y:e+e*Math.sin(a)})}return n}function Kr(i,e){return 2*i+2*Math.PI*e}function El(i,e,t){let n=Kr(i,e),s=Math.PI*e,r=(t%n+n)%n;return r<i/2?{x:r,y:0,outward_rad:-Math.PI/2}:(r-=i/2,r<s?am(i/2,e,-Math.PI/2+r/e):(r-=s,r<i?{x:i/2-r,y:2*e,outward_rad:Math.PI/2}:(r-=i,r<s?am(-i/2,e,Math.PI/2+r/e):{x:-i/2+r-s,y:0,outward_rad:-Math.PI/2})))}function am(i,e,t){return{x:i+e*Math.cos(t),y:e+e*Math.sin(t),outward_rad:t}}function hm(i,e){let t=i.length,n=[],s=-e/2,r=e/2,o=(...a)=>{for(let[l,c]of a){let h=i[l%t]??{x:0,y:0};n.push(h.x,c,h.y)}};for(let a=0;a<t;a++)o([a,s],[a+1,r],[a+1,s]),o([a,s],[a,r],[a+1,r]);for(let a=1;a<t-1;a++)o([0,s],[a,s],[a+1,s]),o([0,r],[a+1,r],[a,r]);return new Float32Array(n)}function lm(i,e,t){let n=Math.cos(i.heading_rad),s=Math.sin(i.heading_rad),r=e-i.x_m,o=t-i.y_m;return{x:n*r+s*o,y:-s*r+n*o}}function Li(i,e,t){let n=Math.cos(i.heading_rad),s=Math.sin(i.heading_rad);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([r=0,o=0])=>{let a=r*e/2,l=o*t/2;return{x:i.x_m+n*a-s*l,y:i.y_m+s*a+n*l}})}function Jr(i){return 2*(Yu(i)[1]?.x??0)}function Xx(i,e,t){let n=0;for(let s of i.ramps){let r=lm(s,e,t),o=Jr(s)/2;if(Math.abs(r.y)>s.width_m/2||Math.abs(r.x)>=o)continue;let a=Math.min((r.x+o)*Math.tan(s.up_rad),(o-r.x)*Math.tan(s.down_rad));n=Math.max(n,Math.min(a,s.height_m))}for(let s of i.blocks){let r=lm(s,e,t);Math.abs(r.y)<=s.width_m/2&&Math.abs(r.x)<=s.depth_m/2&&(n=Math.max(n,s.height_m))}return n}function um(i,e=.005){let t=[];return i.path.forEach((n,s)=>{let r=i.path[s-1],o=r===void 0?1:Math.ceil(Math.hypot(n.x_m-r.x_m,n.y_m-r.y_m)/e);for(let a=1;a<=o;a++){let l=r===void 0?n.x_m:r.x_m+(n.x_m-r.x_m)*a/o,c=r===void 0?n.y_m:r.y_m+(n.y_m-r.y_m)*a/o;t.push(l,c,Xx(i,l,c))}}),new Float32Array(t)}function jr(i){let e={min_x:1/0,max_x:-1/0,min_y:1/0,max_y:-1/0},t=(s,r)=>{e.min_x=Math.min(e.min_x,s),e.max_x=Math.max(e.max_x,s),e.min_y=Math.min(e.min_y,r),e.max_y=Math.max(e.max_y,r)};for(let s of i?.path??[])t(s.x_m,s.y_m);for(let s of i?.ramps??[])for(let{x:r,y:o}of Li(s,Jr(s),s.width_m))t(r,o);for(let s of i?.blocks??[])for(let{x:r,y:o}of Li(s,s.depth_m,s.width_m))t(r,o);let n=i?.fence;return n&&(t(n.min_x_m,n.min_y_m),t(n.max_x_m,n.max_y_m)),e.min_x>e.max_x?{min_x:-1,max_x:1,min_y:-.6,max_y:.6}:e}function dm(i,e,t,n,s,r){let o=i.length/3;for(let a=e;a<t;a++){let l=3*Math.max(a-1,0),c=3*Math.min(a+1,o-1),h=3*a,d=(i[c]??0)-(i[l]??0),u=(i[c+1]??0)-(i[l+1]??0),p=Math.hypot(d,u)||1;d*=n/2/p,u*=n/2/p;let g=i[h]??0,v=i[h+1]??0,f=(i[h+2]??0)+s;r.set([g-u,v+d,f,g+u,v-d,f],6*a)}}var Di="#f2f5f8",vi={model:"#ff5b52",odometry:"#4d9fff",fused:"#3ad07c",truth:"#ffd23f"},ia="#58b7e8",sa="#f0a35e";var $u="#0b1016",Tl="#0b131d",Al="#212d3b",Cl="#34465a",Rl="#4a5868",Ws="#6b7785",ra="#aeb9c6",Qr="#37506b";var Zu="#7f8c9b";var Pl=.12;function fm(i,e){let t=G("button",{type:"button",class:"control card-choose"},i.in_force?"In use":"Choose");t.dataset.fixed=String(i.in_force||i.why_not!==""),t.setAttribute("aria-label",`Choose course ${i.name}`),t.addEventListener("click",()=>{e.choose(i)});let n=G("div",{class:"card-buttons"},t);i.from!=="given"&&n.append(G("a",{href:`/courses/${i.name}.toml`,download:""},"file")),i.from==="own"&&n.append(qx(i,e));let s=G("li",{class:"card",id:`course-${i.name}`},Yx(i),G("div",{class:"card-text"},G("h3",{},i.name,...i.from==="own"?[G("span",{class:"card-own"}," yours")]:[]),G("p",{class:"card-about"},i.description??""),G("p",{class:"card-facts"},om(i))),n);return i.in_force&&s.setAttribute("aria-current","true"),i.why_not!==""&&s.append(G("p",{class:"card-why"},i.why_not)),s}function qx(i,e){let t=G("button",{type:"button",class:"link card-delete"},"delete");return t.dataset.fixed=String(i.in_force),t.addEventListener("click",()=>{t.textContent==="delete"?t.textContent="really delete":e.remove(i)}),t.addEventListener("blur",()=>{t.textContent="delete"}),t}function Yx(i){let e=Il("svg",{class:"card-outline",role:"img","aria-label":`Outline of course ${i.name}`}),t=i.outline??[];if(t.length===0)return e;let n=f=>(f??[]).map(m=>Li(m,m.length_m,m.width_m)),s=[...n(i.ramps),...n(i.blocks)],r=[...t.map(({x_m:f,y_m:m})=>({x:f,y:m})),...s.flat()],[o,a]=[r.map(({x:f})=>f),r.map(({y:f})=>f)],[l,c]=[Math.min(...o)-Pl,Math.max(...a)+Pl],h=Math.max(...o)+Pl-l,d=c-Math.min(...a)+Pl;e.setAttribute("viewBox",`${l} ${-c} ${h} ${d}`);let u=f=>f.map(({x:m,y})=>`${m.toFixed(3)},${(-y).toFixed(3)}`).join(" "),p=(f,m)=>{for(let y of f)e.append(Il("polygon",{points:u(y),fill:m}))};p(n(i.surfaces),Qr),p(s,Ws);let g=t.map(({x_m:f,y_m:m})=>({x:f,y:m}));e.append(Il("polyline",{points:u(g),fill:"none",stroke:Di,"stroke-width":"1.5","stroke-linejoin":"round","vector-effect":"non-scaling-stroke"}));let v=i.start;if(v!==void 0){let f=.05*Math.max(h,d);e.append(Il("circle",{cx:String(v.x_m),cy:String(-v.y_m),r:String(f),fill:vi.fused}))}return e}function Il(i,e){let t=document.createElementNS("http://www.w3.org/2000/svg",i);for(let[n,s]of Object.entries(e))t.setAttribute(n,s);return t}var $x=5e3,Zx={stand:"tracks turn freely, everything else is virtual",flat:"a flat floor; ramps and blocks are virtual",terrain:"ramps and blocks are really there"},Kx="The real floor does not change with the course: with set-up terrain its ramps and blocks must stand there. An emulated robot keeps the floor and the disturbances that it was started with.",Ll=class{constructor(e,t,n=()=>performance.now()){this.ask=e;this.drawPlace=t;this.now=n;this.element.append(G("div",{class:"courses-bar"},G("label",{},"robot ",this.robots),G("label",{},"set-up ",this.setups),this.placeStart,this.placeMap,this.upload,this.file),this.why,G("div",{class:"courses-answer"},this.said,this.replace),this.cards,G("p",{class:"courses-floor"},Kx)),this.robots.addEventListener("change",()=>{this.change({name:"choose",request:{robot:this.robots.value}})}),this.setups.addEventListener("change",()=>{this.change({name:"choose",request:{setup:this.setups.value}})}),this.placeStart.addEventListener("click",()=>{this.change({name:"place",request:{at:"start"}})}),this.placeMap.addEventListener("click",()=>{this.drawPlace(this.placeMap.getAttribute("aria-pressed")!=="true")}),this.upload.addEventListener("click",()=>{this.file.click()}),this.file.addEventListener("change",()=>{let s=this.file.files?.[0];s!==void 0&&this.take(s),this.file.value=""}),this.replace.addEventListener("click",()=>{let s=this.replaced;s!==void 0&&this.save(s,!0)}),this.dropFiles()}ask;drawPlace;now;element=G("div",{class:"courses",tabindex:"0"});robots=G("select",{id:"choose-robot","aria-label":"Robot"});setups=G("select",{id:"choose-setup","aria-label":"Set-up"});placeStart=G("button",{type:"button",class:"control",id:"place-start"},"Place at start");placeMap=G("button",{type:"button",class:"control",id:"place-map","aria-pressed":"false"},"Place on the map");upload=G("button",{type:"button",class:"control",id:"upload"},"Upload");file=G("input",{type:"file",accept:".toml","aria-label":"Course or robot file",hidden:""});why=G("p",{class:"courses-why",role:"status"});said=G("p",{class:"courses-said",role:"alert"});replace=G("button",{type:"button",class:"control",id:"upload-replace",hidden:""},"Replace it");cards=G("ol",{class:"cards"});list;shown="";next_ms=0;asking=!1;mayChange=!1;replaced;show(e,t,n){let s=e.get("/state"),r=Jx(s,t&&!e.stale("/state"),n);this.mayChange=r===""&&!this.asking,et(this.why,r),this.enable();let o=`${s?.course??""} ${s?.robot??""} ${s?.setup??""}`;this.element.dataset.named!==o&&(this.next_ms=0),this.element.dataset.named=o,!(this.now()<this.next_ms||!t)&&(this.next_ms=this.now()+$x,this.load())}placed(e){yt(this.placeMap,"aria-pressed","false"),e!==void 0&&this.change({name:"place",request:e})}drawing(e){yt(this.placeMap,"aria-pressed",String(e)),e&&this.say("Press on the map where the robot is, and drag towards where it points.")}enable(){let e=this.mayChange&&this.list!==void 0;for(let t of[this.robots,this.setups,this.placeMap])t.disabled=!e;this.placeStart.disabled=!e||this.list?.course==="",this.upload.disabled=this.replace.disabled=!e||this.list?.may_save!==!0,yt(this.upload,"title",this.list?.may_save===!1?"There is no folder for your files: set library in the configuration":"A course or robot file (TOML)");for(let t of this.cards.querySelectorAll("button"))t.disabled=!e||t.dataset.fixed==="true"}async load(){try{let e=await fetch("/api/setup",{cache:"no-store"});if(!e.ok)throw new Error(e.statusText);let t=await e.text();if(t===this.shown)return;this.shown=t,this.list=JSON.parse(t),this.build(this.list)}catch{this.shown="",this.say("The list of courses is not available now.")}}build(e){let t=(o,a,l)=>{let c=G("option",{value:o},a===""?o:`${o}: ${a}`);return c.disabled=l!=="",l!==""&&(c.title=l),c};this.robots.replaceChildren(...e.robots.map(o=>t(o.name,o.description??"",o.why_not))),this.robots.value=e.robot,this.setups.replaceChildren(...e.setups.map(o=>t(o,Zx[o]??"",""))),this.setups.value=e.setup;let n=o=>+(o.identifies===!0)-+(o.from!=="bundled"),s=[...e.courses].sort((o,a)=>n(o)-n(a)),r={choose:({name:o})=>{this.change({name:"choose",request:{course:o}})},remove:({name:o})=>{this.change({name:"file_delete",request:{kind:"course",name:o}})}};this.cards.replaceChildren(...s.map(o=>fm(o,r))),this.enable()}async change(e){this.asking=!0,this.mayChange=!1,this.say(""),this.enable();try{return await this.ask(e),!0}catch(t){return this.say(t instanceof Error?t.message:String(t)),!1}finally{this.asking=!1,this.shown="",this.next_ms=0}}async take(e){if(e.size>6e4){this.say(`${e.name} has ${e.size} bytes; at most ${6e4} are taken`);return}let t=await e.text();await this.save({kind:sm(t),name:rm(e.name),text:t},!1)}async save(e,t){let n=e.kind==="course"?this.list?.courses:this.list?.robots;if(!t&&n?.some(({name:s,from:r})=>s===e.name&&r==="own")===!0){this.say(`You have a ${e.kind} named ${e.name} already.`),this.replaced=e,this.replace.hidden=!1;return}await this.change({name:"file_save",request:{...e,replace:t}})&&this.say(`${e.name} is saved.`)}say(e){this.replaced=void 0,this.replace.hidden=!0,et(this.said,e)}dropFiles(){this.element.addEventListener("dragover",e=>{e.preventDefault(),this.element.classList.add("dropping")}),this.element.addEventListener("dragleave",()=>{this.element.classList.remove("dropping")}),this.element.addEventListener("drop",e=>{e.preventDefault(),this.element.classList.remove("dropping");let t=e.dataTransfer?.files[0];t!==void 0&&!this.upload.disabled&&this.take(t)})}};function Jx(i,e,t){return!e||i===void 0?"No connection to tp100d.":t?i.run==="arming"||i.run==="running"?"A run is under way: nothing can be changed.":i.run==="driving"?"The robot is driven by hand: release it first.":"":"This daemon takes no commands from here but STOP (server.commands)."}var jx=3e3,Qx="This daemon takes no commands from here but STOP (server.commands)",ev={none:"no control held",keys:"keys",stick:"stick",gamepad:"gamepad"},Dl=class{constructor(e,t,n=()=>performance.now()){this.driver=e;this.inputs=t;this.now=n;this.stick=new Ku(s=>{t.touch(s),e.tick()}),this.button.append(es("wheel"),this.label),this.button.addEventListener("click",()=>{this.press()}),this.release.addEventListener("click",()=>{e.release()}),this.share.addEventListener("input",()=>{e.share=this.share.valueAsNumber/100});for(let[s,r]of[["speed","speed"],["turn","turn"]]){let o=G("dd",{id:`drive-${s}`});this.values.set(s,o),this.facts.append(G("dt",{},r),o)}this.element.append(this.stick.element,G("div",{class:"drive-text"},this.source,this.facts,G("label",{class:"drive-limit",for:"drive-share"},"at most ",this.shareText),this.share,this.asked),this.release)}driver;inputs;now;button=G("button",{type:"button",id:"drive",class:"control","aria-keyshortcuts":"m"});element=G("section",{class:"drive-panel","aria-label":"Driving by hand",hidden:""});label=G("span",{class:"button-label"},"Drive");stick;source=G("p",{class:"drive-source",role:"status"});facts=G("dl",{class:"drive-facts"});values=new Map;share=G("input",{type:"range",id:"drive-share",min:"10",max:"100",step:"5",value:"50","aria-label":"Greatest speed"});shareText=G("output",{for:"drive-share"});asked=G("p",{class:"drive-asked",role:"status"});release=G("button",{type:"button",class:"control",id:"drive-release"},"Release");confirmUntil_ms=0;needsConfirmation=!0;press(){if(this.button.disabled||this.driver.drives)return;let e=this.now();if(this.needsConfirmation&&e>this.confirmUntil_ms){this.confirmUntil_ms=e+jx;return}this.confirmUntil_ms=0,this.driver.take()}forget(){this.confirmUntil_ms=0}show(e,t,n){let s=e.get("/state"),r=t&&n&&s!==void 0&&!e.stale("/state");this.showButton(s,r,n);let o=this.driver.drives;if(this.element.hidden===o&&(this.element.hidden=!o),!o){this.stick.letGo();return}let a=e.get("/parameter")?.parameters??[],l=(c,h)=>{let d=a.find(u=>u.name===c)?.value;return typeof d=="number"?d:h};this.driver.limits={speed_mps:l("robot.drive.max_track_mps",.2),yaw_rate_radps:l("robot.drive.max_yaw_radps",1)},this.showDrive(e,s)}showButton(e,t,n){this.needsConfirmation=e?.confirm_start!==!1;let s=e?.driver?.fresh===!0&&!this.driver.drives;this.button.disabled=!(t&&!this.driver.drives&&(e?.can.drive===!0||s));let r=this.now()<this.confirmUntil_ms;nn(this.button,"confirm",r),et(this.label,r?"Press again":s?"Ask":"Drive");let o=n?e?.why_not_drive??"":Qx,a=s?`${o}: ask for the wheel`:o;yt(this.button,"title",a===""?"Drive by hand (m)":a)}showDrive(e,t){let n=this.driver.wish,s=e.get("/estimate"),r=s?.[s.steering],o=t?.run==="driving";nn(this.element,"frozen",this.inputs.frozen);let a=this.inputs.frozen?"gamepad: its values stand still; move the stick":o?s?.at_fence===!0?"at the fence":ev[n?.source??"none"]:"arming…";et(this.source,a);let{speed_mps:l,yaw_rate_radps:c}=this.driver.limits,h=`${dt(r?.vx_mps,3)} m/s, commanded ${dt(s?.desired_speed_mps,3)}`,d=`${Qi(r?.yaw_rate_radps,0)}°/s, wanted ${Qi((n?.left??0)*this.driver.share*c,0)}`,[u,p]=[this.values.get("speed"),this.values.get("turn")];u&&et(u,h),p&&et(p,d);let g=this.driver.share*l;et(this.shareText,`${dt(g,2)} of ${dt(l,2)} m/s, ${Qi(this.driver.share*c,0)}°/s`);let v=t?.driver?.asked_by??"";et(this.asked,v===""?"":`${v} asks for the wheel`),this.stick.show(n?.forward??0,n?.left??0)}},Ku=class{constructor(e){this.moved=e;this.element.append(this.knob),this.element.addEventListener("pointerdown",t=>{this.pointer!==void 0||t.button!==0||(t.preventDefault(),this.pointer=t.pointerId,this.element.setPointerCapture(t.pointerId),this.move(t))}),this.element.addEventListener("pointermove",t=>{t.pointerId===this.pointer&&this.move(t)});for(let t of["pointerup","pointercancel","lostpointercapture"])this.element.addEventListener(t,n=>{n.pointerId===this.pointer&&this.letGo()})}moved;element=G("div",{class:"drive-stick","aria-hidden":"true"});knob=G("div",{class:"drive-knob"});pointer;letGo(){this.pointer!==void 0&&(this.pointer=void 0,this.moved(void 0))}show(e,t){this.knob.style.transform=`translate(${(-75*t).toFixed(1)}%, ${(-75*e).toFixed(1)}%)`}move(e){let t=this.element.getBoundingClientRect(),n=t.width/2,s=(e.clientX-t.left-n)/n,r=(e.clientY-t.top-n)/n,o=Math.max(1,Math.hypot(s,r)),a=l=>Math.abs(l)<.08?0:l;this.moved({forward:a(-r/o),left:a(-s/o)})}};var Nl=class{constructor(e){this.pages=e;let t=G("div",{class:"tabs",role:"tablist"});this.tabs=e.map((n,s)=>{let r=G("button",{type:"button",role:"tab",id:`tab-${n.id}`,"aria-controls":`page-${n.id}`},n.title);return r.addEventListener("click",()=>{this.choose(s)}),r.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowLeft:-1}[o.key];a!==void 0&&(this.choose((this.current+a+e.length)%e.length),this.tabs[this.current]?.focus())}),r}),t.append(...this.tabs),this.element.append(t);for(let n of e)yt(n.element,"id",`page-${n.id}`),yt(n.element,"role","tabpanel"),yt(n.element,"aria-labelledby",`tab-${n.id}`),n.element.classList.add("page"),this.element.append(n.element);this.choose(0)}pages;element=G("section",{class:"drawer","aria-label":"Details"});tabs;current=0;show(){this.pages[this.current]?.show()}select(e){this.choose(this.pages.findIndex(t=>t.id===e))}choose(e){this.current=e,this.pages.forEach((t,n)=>{let s=n===e;t.element.hidden=!s;let r=this.tabs[n];r!==void 0&&(yt(r,"aria-selected",String(s)),r.tabIndex=s?0:-1)}),this.show()}};var Ul=class{constructor(e,t,n=0){this.width=e;this.capacity=t;this.interval_s=n;this.columns=Array.from({length:e},()=>new Float64Array(2*t))}width;capacity;interval_s;columns;end=0;filled=0;get length(){return this.filled}get last_s(){return this.filled===0?NaN:this.columns[0]?.[this.end-1]??NaN}push(e){let t=e[0]??NaN;if(this.filled>0){if(t<this.last_s)this.clear();else if(t-this.last_s<this.interval_s)return}if(this.end===2*this.capacity){for(let n of this.columns)n.copyWithin(0,this.capacity);this.end=this.capacity}for(let n=0;n<this.width;n++){let s=this.columns[n];s!==void 0&&(s[this.end]=e[n]??NaN)}this.end++,this.filled=Math.min(this.filled+1,this.capacity)}clear(){this.end=0,this.filled=0}since(e){let t=this.columns[0],n=this.end-this.filled,s=this.end;for(;t!==void 0&&n<s;){let o=n+s>>1;(t[o]??1/0)<e?n=o+1:s=o}let r=Math.max(n-1,this.end-this.filled);return this.columns.map(o=>o.subarray(r,this.end))}};var gr=class{constructor(e=4e3,t=.01){this.capacity=e;this.firstSpacing_m=t;this.points=new Float32Array(3*e),this.spacing_m=t}capacity;firstSpacing_m;points;count=0;spacing_m;changes=0;get length(){return this.count}get generation(){return this.changes}get coordinates(){return this.points.subarray(0,3*this.count)}add(e,t,n){if(!Number.isFinite(e+t+n))return;let s=3*(this.count-1);this.count>0&&Math.hypot(e-(this.points[s]??0),t-(this.points[s+1]??0))<this.spacing_m*.999||(this.count===this.capacity&&this.thin(),this.points.set([e,t,n],3*this.count),this.count++)}clear(){this.count=0,this.spacing_m=this.firstSpacing_m,this.changes++}thin(){let e=this.count>>1;for(let t=0;t<e;t++)this.points.copyWithin(3*t,6*t,6*t+3);this.count=e,this.spacing_m*=2,this.changes++}};var qn=["model","odometry","fused","truth"],Ju={t_s:0,desired_yaw_deg:1,model_yaw_deg:2,odometry_yaw_deg:3,fused_yaw_deg:4,truth_yaw_deg:5,cross_track_mm:6,heading_error_deg:7,left_mps:8,right_mps:9,left_commanded_mps:10,right_commanded_mps:11,slip_left_percent:12,slip_right_percent:13,fused_slip_left_percent:14,fused_slip_right_percent:15,model_error_mm:16,odometry_error_mm:17,fused_error_mm:18},ju=120,mm=.0199,Qu=300,tv=.5,nv={"/estimate":400,"/slip":600,"/link":1e3,"/loop":1500,"/state":1e3,"/course":1/0,"/event":1/0,"/parameter":1/0,"/recording":1/0,"/client":3e3,"/path_history":1/0},iv=4e5,oa=class{constructor(e=()=>performance.now()){this.now=e}now;series=new Ul(Object.keys(Ju).length,Math.ceil(ju/mm),mm);path_histories={model:new gr,odometry:new gr,fused:new gr,truth:new gr};events=[];leftTrack_m=0;rightTrack_m=0;received={};latest={};received_ms={};get(e){return this.latest[e]}receive(e,t){e==="/estimate"?this.estimate(t):e==="/event"?this.event(t):e==="/state"?this.state(t):e==="/path_history"&&this.history(t),this.latest[e]=t,this.received_ms[e]=this.now(),this.received[e]=(this.received[e]??0)+1}stale(e){let t=this.received_ms[e];if(t===void 0||this.now()-t>nv[e])return!0;if(e!=="/estimate"&&e!=="/slip")return!1;let n=this.latest["/estimate"]?.age_us;return n==null||n>iv}get pose(){let e=this.latest["/estimate"];return e?.[e.steering]}clear(){this.series.clear(),this.clearTrails(),this.events.length=0,this.leftTrack_m=this.rightTrack_m=0;for(let e of Object.keys(this.latest))Reflect.deleteProperty(this.latest,e)}clearTrails(){for(let e of qn)this.path_histories[e].clear()}estimate(e){let t=this.latest["/estimate"];if(t!==void 0){let n=e.t_s-t.t_s;n>0&&n<1&&(this.leftTrack_m+=e.tracks.left_mps*n,this.rightTrack_m+=e.tracks.right_mps*n),(Math.hypot(e.model.x_m-t.model.x_m,e.model.y_m-t.model.y_m)>tv||n<0)&&this.clearTrails()}for(let n of qn){let s=e[n];s&&this.path_histories[n].add(s.x_m,s.y_m,s.z_m)}this.series.push(sv(e,this.latest["/slip"]))}event(e){this.events.some(n=>n.t_s===e.t_s&&n.text===e.text)||(this.events.push(e),this.events.length>Qu&&this.events.shift())}state(e){e.run==="running"&&this.latest["/state"]?.run==="arming"&&this.clearTrails()}history(e){for(let t of["model","odometry","fused"]){let n=this.path_histories[t];if(n.length>10)continue;let s=e.entities.filter(r=>r.id.startsWith(`path_history/${t}/`));if(s.length!==0){n.clear();for(let r of s)for(let o of r.lines)for(let{x:a,y:l,z:c}of o.points)n.add(a,l,c)}}}};function sv(i,e){let{model:t,odometry:n,fused:s,truth:r,tracks:o}=i,a=c=>(c??NaN)*180/Math.PI,l=c=>r?1e3*Math.hypot(c.x_m-r.x_m,c.y_m-r.y_m):NaN;return[i.t_s,a(i.desired_yaw_rad),a(t.yaw_rad),a(n.yaw_rad),a(s.yaw_rad),a(r?.yaw_rad),1e3*i.cross_track_m,a(i.heading_error_rad),o.left_mps,o.right_mps,o.left_commanded_mps??NaN,o.right_commanded_mps??NaN,100*(e?.left??NaN),100*(e?.right??NaN),100*(e?.fused_left??NaN),100*(e?.fused_right??NaN),l(t),l(n),l(s)]}var Fl=class{element=G("div",{class:"events",tabindex:"0"});list=G("ol",{class:"event-list",role:"log"});shown=[];source;constructor(){this.element.append(this.list)}show(e){(e!==this.source||e.events.length===0)&&(this.source=e,this.shown=[],this.list.replaceChildren());let t=this.shown.at(-1),n=t===void 0?0:e.events.lastIndexOf(t)+1;for(let s of e.events.slice(n))this.list.prepend(rv(s));for(;this.list.children.length>Qu;)this.list.lastElementChild?.remove();this.shown=e.events.slice(-1)}};function rv(i){let e=[i.cause,i.fix].filter(t=>t!=="").join(" — ");return G("li",{class:"event","data-level":i.level,"data-kind":i.kind},G("time",{},Ii(i.t_s)),G("span",{class:"event-kind"},i.kind),G("span",{class:"event-text"},i.text,...e===""?[]:[G("span",{class:"event-cause"},e)]))}var Ol=class{element;bars=G("div",{class:"bars",role:"img"});labels=G("div",{class:"bar-labels","aria-hidden":"true"});figures;edges="";shown=-1;constructor(){let e=()=>G("span",{class:"plot-value wide"});this.figures={p50:e(),"p99.9":e(),max:e()};let t=G("div",{class:"plot-key"});for(let[n,s]of Object.entries(this.figures))t.append(G("span",{class:"plot-curve"},n,s));this.element=G("section",{class:"plot histogram",id:"plot-lateness","aria-label":"Lateness of the loop"},G("header",{},G("h2",{},"Loop lateness",G("span",{class:"plot-unit"},"cycles, log")),t),this.bars,this.labels)}show(e){let t=e.get("/loop");nn(this.element,"stale",e.stale("/loop"));let n=e.received["/loop"]??0;if(t===void 0||n===this.shown)return;this.shown=n;let{edges_us:s,lateness:r}=t.histogram;this.build(s);let o=Math.log10(Math.max(10,...r)+1);r.forEach((l,c)=>{let h=this.bars.children[c];if(h===void 0)return;h.style.transform=`scaleY(${(l===0?0:Math.max(.02,Math.log10(l+1)/o)).toFixed(3)})`;let d=c===0?"below ":`${Ht(s[c-1])} to `;yt(h,"title",`${c===s.length?"over "+Ht(s.at(-1)):d+Ht(s[c])}: ${Rn(l)}`)}),et(this.figures.p50,Ht(t.lateness_us.p50)),et(this.figures["p99.9"],Ht(t.lateness_us.p999)),et(this.figures.max,Ht(t.lateness_us.max));let a=`median ${Ht(t.lateness_us.p50)}, worst ${Ht(t.lateness_us.max)} of ${Rn(t.cycles)} turns`;yt(this.bars,"aria-label",a)}reset(){this.shown=-1,this.edges="",this.bars.replaceChildren(),this.labels.replaceChildren();for(let e of Object.values(this.figures))et(e,"")}build(e){let t=e.join();t!==this.edges&&(this.edges=t,this.bars.replaceChildren(...[...e,0].map(()=>G("i"))),this.labels.replaceChildren(...[...e,0].map((n,s)=>{let r=s<e.length&&Number.isInteger(Math.log10(n));return G("span",{},...r?[G("b",{},Ht(n))]:[])})))}};var ov=[["space, esc","STOP"],["r","start; asks for confirmation, or where the robot stands"],["h","hold: ends the run or the drive and disarms"],["m","drive by hand: takes the wheel; asks for confirmation"],["arrows; w, a, s, d","while this page drives: forwards, left, backwards, right, as long as they are held"],["1, 2, 3, 4","view: chase, top, free, map"],["c","next view"],["[, ]","step through a recording"],["?","this list"],["tab, arrows","from control to control; between the tabs"]];function gm(){let i=G("dl",{class:"keys"});for(let[e,t]of ov)i.append(G("dt",{},G("kbd",{},e)),G("dd",{},t));return i}var kl=({p50:i,p99:e})=>`${Ht(i)}, ${Ht(e)}`,Bl=class{element=G("div",{class:"facts",tabindex:"0"});groups=new Map;show(e){let t=e.get("/link"),n=e.get("/loop"),s=e.get("/client");t!==void 0&&(this.group("Link",e.stale("/link"),[["port",t.port],["robot",t.kind??"–"],["firmware",t.firmware??"–"],["session",t.session],["samples",`${dt(t.samples_hz,1)} Hz`],["in, out",`${Hs(t.in_bytes_ps)}/s, ${Hs(t.out_bytes_ps)}/s`],["round trip",Ht(t.round_trip_us)],["clock",t.clock.valid?`${dt(t.clock.drift_ppm,1)} ppm ±${Ht(t.clock.uncertainty_us)}`:"–"],["sample age p50",Ht(t.sample_age_us.p50)],["sample age p99.9",Ht(t.sample_age_us.p999)]]),this.group("Counters",e.stale("/link"),Object.entries(t.counters).map(([r,o])=>[r.replaceAll("_"," "),Rn(o)]))),n!==void 0&&this.group("Loop",e.stale("/loop"),[["rate",`${dt(n.rate_hz,0)} Hz, by ${n.pacing}`],["cycles",Rn(n.cycles)],["overruns, missed",`${Rn(n.overruns)}, ${Rn(n.missed)}`],["lateness p50",Ht(n.lateness_us.p50)],["lateness p99.9",Ht(n.lateness_us.p999)],["lateness max",Ht(n.lateness_us.max)],["work p50",Ht(n.work_us.p50)],["work max",Ht(n.work_us.max)],["compute p50, p99",kl(n.compute_us)],["write p50, p99",kl(n.write_us)],["sample on the wire p50, p99",kl(n.sample_wire_us)],["sample waits p50, p99",kl(n.sample_wait_us)],...Object.entries(n.privileges).map(([r,o])=>[r,o?"granted":"refused"])]),s!==void 0&&this.group("Viewers",e.stale("/client"),[["dropped, refused, closed",[s.dropped_total,s.refused_total,s.closed_total].map(Rn).join(", ")],...s.clients.slice(0,20).map(r=>[`${r.id} ${r.address}`,`${Rn(r.sent)} sent, ${Rn(r.dropped)} dropped`])])}group(e,t,n){let s=this.groups.get(e);if(s===void 0){let o=G("dl");s={box:G("section",{class:"fact-group"},G("h3",{},e),o),list:o},this.groups.set(e,s),this.element.append(s.box)}nn(s.box,"stale",t);let{list:r}=s;for(;r.children.length>2*n.length;)r.lastElementChild?.remove();n.forEach(([o,a],l)=>{r.children.length<2*l+2&&r.append(G("dt"),G("dd"));let[c,h]=[r.children[2*l],r.children[2*l+1]];c&&et(c,o),h&&et(h,a)})}};var av=6e3,zl=class{element=G("div",{class:"notice",role:"status","data-level":"none"});list=G("ul",{id:"notice-list"});more=G("button",{type:"button",id:"notice-more","aria-controls":"notice-list","aria-expanded":"false"});close=G("button",{type:"button",id:"notice-close","aria-label":"Close this notice"},es("close"));answer="";answerUntil_ms=0;all=[];open=!1;closed="";shown="";constructor(){this.element.append(this.list,this.more,this.close),this.more.addEventListener("click",()=>{this.open=!this.open,this.render()}),this.close.addEventListener("click",()=>{this.closed=ed(this.all),this.answerUntil_ms=0,this.render()})}say(e,t){this.answer=e,this.answerUntil_ms=t+av,this.closed=""}show(e,t,n,s,r){this.all=lv(e,t,n,r),t&&s<this.answerUntil_ms&&this.all.unshift({level:"warn",what:this.answer,todo:""}),this.render()}render(){this.closed!==""&&this.closed!==ed(this.all)&&(this.closed="");let e=this.closed===""?this.all:[],t=this.open?e:e.slice(0,1),n=ed(t);n!==this.shown&&(this.shown=n,this.list.replaceChildren(...t.map(({what:r,todo:o})=>G("li",{},G("strong",{},r)," ",G("span",{},o))))),yt(this.element,"data-level",t[0]?.level??"none");let s=e.length-1;this.more.hidden=s<1,et(this.more,this.open?"less":`+${s}`),yt(this.more,"aria-label",this.open?"Show the first notice only":`Show ${s} more`),yt(this.more,"aria-expanded",String(this.open))}},ed=i=>JSON.stringify(i);function lv(i,e,t,n){if(!e)return[{level:"bad",what:"No connection to tp100d",todo:t>0?"trying again":"connecting"}];let s=i.get("/state");if(s===void 0)return[];let r=[];if(i.stale("/state")&&r.push({level:"bad",what:"The daemon is silent",todo:"grey values are old"}),s.session!=="ready"&&!n){let a=i.get("/link"),l=a===void 0||a.port===""?"No robot":`No robot on ${a.port}`,c=(a?.note??"").replace(`${a?.port??""}: `,"");r.push({level:"warn",what:l,todo:s.session==="closed"?c:s.why_not_start})}let o=s.run==="finished"?"warn":"bad";for(let a of s.faults)a.name!=="stop_requested"&&r.push({level:o,what:a.cause,todo:a.fix});return r}var cv=[{id:"x",label:"x",unit:"m",topic:"/estimate",text:i=>dt(i.pose?.x_m,3)},{id:"y",label:"y",unit:"m",topic:"/estimate",text:i=>dt(i.pose?.y_m,3)},{id:"yaw",label:"yaw",unit:"°",topic:"/estimate",text:i=>Qi(i.pose?.yaw_rad,1)},{id:"climb",label:"pitch, nose up",unit:"°",topic:"/estimate",text:i=>Qi(i.pose===void 0?null:-i.pose.pitch_rad,1)},{id:"cross-track",label:"cross-track",unit:"mm",topic:"/estimate",text:i=>im(i.get("/estimate")?.cross_track_m,1)},{id:"heading-error",label:"heading",unit:"°",topic:"/estimate",text:i=>Qi(i.get("/estimate")?.heading_error_rad,1)},{id:"left",label:"left track",unit:"m/s",topic:"/estimate",text:i=>dt(i.get("/estimate")?.tracks.left_mps,3)},{id:"right",label:"right track",unit:"m/s",topic:"/estimate",text:i=>dt(i.get("/estimate")?.tracks.right_mps,3)},{id:"slip-left",label:"slip left",unit:"%",topic:"/slip",text:i=>Xu(i.get("/slip")?.left,1)},{id:"slip-right",label:"slip right",unit:"%",topic:"/slip",text:i=>Xu(i.get("/slip")?.right,1)},{id:"age",label:"data age",unit:"ms",topic:"/estimate",text:i=>dt(_m(i),(_m(i)??0)<100?1:0)},{id:"battery",label:"battery",unit:"V",topic:"/state",text:i=>dt(i.get("/state")?.battery_v,2)}];function _m(i){let e=i.get("/estimate")?.age_us??null;return e===null?null:Math.min(Math.max(e/1e3,0),99999)}var Vl=class{element=G("section",{class:"numbers","aria-label":"Figures"});rows;constructor(){this.rows=cv.map(e=>{let t=G("output",{class:"number-value",id:`number-${e.id}`},"–"),n=G("div",{class:"number stale"},G("span",{class:"number-label"},e.label),G("span",{class:"number-line"},t,G("span",{class:"number-unit"},e.unit)));return this.element.append(n),{figure:e,tile:n,value:t}})}show(e){for(let{figure:t,tile:n,value:s}of this.rows)et(s,t.text(e)),nn(n,"stale",e.stale(t.topic))}};var Gl=class{constructor(e){this.set=e;let t=["parameter","value","unit","limits","default","meaning"].map(n=>G("th",{scope:"col"},n));this.element.append(this.filter,G("table",{},G("thead",{},G("tr",{},...t)),this.body)),this.filter.addEventListener("input",()=>{this.narrow()})}set;element=G("div",{class:"parameters",tabindex:"0"});filter=G("input",{type:"search",placeholder:"filter","aria-label":"Filter parameters"});body=G("tbody");shown=-1;rows=[];show(e){let t=e.received["/parameter"]??0;if(t===this.shown||this.element.contains(document.activeElement?.closest("td")??null))return;this.shown=t;let n=[...e.get("/parameter")?.parameters??[]];n.sort((s,r)=>Number(r.live)-Number(s.live)),this.rows=n.map(s=>({text:`${s.name} ${s.meaning}`.toLowerCase(),row:this.row(s)})),this.body.replaceChildren(...this.rows.map(({row:s})=>s)),this.narrow()}narrow(){let e=this.filter.value.trim().toLowerCase();for(let{text:t,row:n}of this.rows)n.hidden=!t.includes(e)}row(e){let t=e.value!==e.default,n=typeof e.min=="number"?`${e.min} … ${e.max??""}`:e.choices.join(" ");return G("tr",{class:[e.live?"live":"",t?"changed":""].join(" ").trim()},G("th",{scope:"row"},e.name),G("td",{class:"figure"},e.live?this.field(e):String(e.value)),G("td",{},e.unit),G("td",{class:"figure"},n),G("td",{class:"figure"},String(e.default)),G("td",{class:"meaning"},e.meaning,e.live&&e.when==="not running"?" (not during a run)":""))}field(e){if(e.type==="choice"){let s=G("select",{"aria-label":e.name});for(let r of e.choices)s.append(G("option",{value:r},r));return s.value=String(e.value),s.addEventListener("change",()=>{this.set(e.name,s.value),s.blur()}),s}if(e.type==="boolean"){let s=G("input",{type:"checkbox","aria-label":e.name});return s.checked=e.value===!0,s.addEventListener("change",()=>{this.set(e.name,s.checked)}),s}let t=G("input",{"aria-label":e.name,inputmode:"decimal",size:"8"});t.value=String(e.value);let n=e.type==="number"||e.type==="integer";return t.addEventListener("change",()=>{let s=n?Number(t.value):t.value,r=n&&(t.value.trim()===""||!Number.isFinite(s)||Number(s)<(e.min??-1/0)||Number(s)>(e.max??1/0));t.setAttribute("aria-invalid",String(r)),r||this.set(e.name,s)}),t.addEventListener("keydown",s=>{s.key==="Enter"&&t.blur()}),t}};var hv=12,Hl=class{constructor(e,t,n){this.world=e;this.yaw_rad=t;this.done=n;let s=document.createElementNS("http://www.w3.org/2000/svg","svg");s.append(this.arrow),this.element.append(s),this.element.addEventListener("pointerdown",r=>{r.isPrimary&&(this.element.setPointerCapture(r.pointerId),this.from=this.at(r),this.draw(this.from))}),this.element.addEventListener("pointermove",r=>{this.from!==void 0&&this.draw(this.at(r))}),this.element.addEventListener("pointercancel",()=>{this.from=void 0}),this.element.addEventListener("pointerup",r=>{this.finish(this.at(r))})}world;yaw_rad;done;element=G("div",{class:"placing",hidden:""});arrow=document.createElementNS("http://www.w3.org/2000/svg","line");from;show(e){this.element.hidden=!e,this.from=void 0,this.arrow.style.display="none"}at(e){let t=this.element.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}draw(e){let t=this.from??e;this.arrow.style.display="";for(let[n,s]of[["x1",t.x],["y1",t.y],["x2",e.x],["y2",e.y]])yt(this.arrow,n,s.toFixed(1))}finish(e){let t=this.from;if(this.from=void 0,t===void 0)return;let n=this.world(t),s=this.world(e);if(n===void 0||s===void 0){this.done(void 0);return}let o=Math.hypot(e.x-t.x,e.y-t.y)>=hv?Math.atan2(s.y-n.y,s.x-n.x):this.yaw_rad();this.done({x_m:n.x,y_m:n.y,yaw_rad:o})}};var uv="uplot",dv="u-hz",fv="u-vt",pv="u-title",mv="u-wrap",gv="u-under",_v="u-over",xv="u-axis",vr="u-off",vv="u-select",yv="u-cursor-x",bv="u-cursor-y",Sv="u-cursor-pt",Mv="u-legend",wv="u-live",Ev="u-inline",Tv="u-series",Av="u-marker",xm="u-label",Cv="u-value",la="width",ca="height";var vm="bottom",to="left",td="right",xd="#000",ym=xd+"0",nd="mousemove",bm="mousedown",id="mouseup",Sm="mouseenter",Mm="mouseleave",wm="dblclick",Rv="resize",Pv="scroll",Em="change",$l="dppxchange",vd="--",lo=typeof window<"u",ld=lo?document:null,io=lo?window:null,Iv=lo?navigator:null,Et,Wl;function cd(){let i=devicePixelRatio;Et!=i&&(Et=i,Wl&&ud(Em,Wl,cd),Wl=matchMedia(`(min-resolution: ${Et-.001}dppx) and (max-resolution: ${Et+.001}dppx)`),yr(Em,Wl,cd),io.dispatchEvent(new CustomEvent($l)))}function ci(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function hd(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Wt(i,e,t){i.style[e]=t+"px"}function Ni(i,e,t,n){let s=ld.createElement(i);return e!=null&&ci(s,e),t?.insertBefore(s,n),s}function yi(i,e){return Ni("div",i,e)}var Tm=new WeakMap;function ts(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Tm.get(i);r!=o&&(i.style.transform=r,Tm.set(i,r),e<0||t<0||e>n||t>s?ci(i,vr):hd(i,vr))}var Am=new WeakMap;function Cm(i,e,t){let n=e+t,s=Am.get(i);n!=s&&(Am.set(i,n),i.style.background=e,i.style.borderColor=t)}var Rm=new WeakMap;function Pm(i,e,t,n){let s=e+""+t,r=Rm.get(i);s!=r&&(Rm.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var yd={passive:!0},Lv={...yd,capture:!0};function yr(i,e,t,n){e.addEventListener(i,t,n?Lv:yd)}function ud(i,e,t,n){e.removeEventListener(i,t,yd)}lo&&cd();function Ui(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:hi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function sg(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var rg=i=>i!=null,og=i=>i!=null&&i>0,Jl=sg(rg),Dv=sg(og);function Nv(i,e,t,n=0,s=!1){let r=s?Dv:Jl,o=s?og:rg;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ft,l??-Ft]}function jl(i,e,t,n){let s=Dm(i),r=Dm(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?xs:ag,a=s==1?hi:bi,l=r==1?bi:hi,c=a(o(yn(i))),h=l(o(yn(e))),d=so(t,c),u=so(t,h);return t==10&&(c<0&&(d=Ot(d,-c)),h<0&&(u=Ot(u,-h))),n||t==2?(i=d*s,e=u*r):(i=ug(i,d),e=Ql(e,u)),[i,e]}function bd(i,e,t,n){let s=jl(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Sd=.1,Im={mode:3,pad:Sd},ua={pad:0,soft:null,mode:0},Uv={min:ua,max:ua};function Zl(i,e,t,n){return ec(t)?Lm(i,e,t):(ua.pad=t,ua.soft=n?0:null,ua.mode=n?3:0,Lm(i,e,Uv))}function Mt(i,e){return i??e}function Fv(i,e,t){for(e=Mt(e,0),t=Mt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Lm(i,e,t){let n=t.min,s=t.max,r=Mt(n.pad,0),o=Mt(s.pad,0),a=Mt(n.hard,-Ft),l=Mt(s.hard,Ft),c=Mt(n.soft,Ft),h=Mt(s.soft,-Ft),d=Mt(n.mode,0),u=Mt(s.mode,0),p=e-i,g=xs(p),v=Yn(yn(i),yn(e)),f=xs(v),m=yn(f-g);(p<1e-24||m>10)&&(p=0,(i==0||e==0)&&(p=1e-24,d==2&&c!=Ft&&(r=0),u==2&&h!=-Ft&&(o=0)));let y=p||v||1e3,A=xs(y),w=so(10,hi(A)),R=y*(p==0?i==0?.1:1:r),E=Ot(ug(i-R,w/10),24),x=i>=c&&(d==1||d==3&&E<=c||d==2&&E>=c)?c:Ft,T=Yn(a,E<x&&i>=x?x:Fi(x,E)),B=y*(p==0?e==0?.1:1:o),N=Ot(Ql(e+B,w/10),24),D=e<=h&&(u==1||u==3&&N>=h||u==2&&N<=h)?h:-Ft,W=Fi(l,N>D&&e<=D?D:Yn(D,N));return T==W&&T==0&&(W=100),[T,W]}var Ov=new Intl.NumberFormat(lo?Iv.language:"en-US"),Md=i=>Ov.format(i),ui=Math,Yl=ui.PI,yn=ui.abs,hi=ui.floor,vn=ui.round,bi=ui.ceil,Fi=ui.min,Yn=ui.max,so=ui.pow,Dm=ui.sign,xs=ui.log10,ag=ui.log2,kv=(i,e=1)=>ui.sinh(i)*e,sd=(i,e=1)=>ui.asinh(i/e),Ft=1/0;function Nm(i){return(xs((i^i>>31)-(i>>31))|0)+1}function dd(i,e,t){return Fi(Yn(i,e),t)}function lg(i){return typeof i=="function"}function xt(i){return lg(i)?i:()=>i}var Bv=()=>{},cg=i=>i,hg=(i,e)=>e,zv=i=>null,Um=i=>!0,Fm=(i,e)=>i==e,Vv=/\.\d*?(?=9{6,}|0{6,})/gm,br=i=>{if(fg(i)||qs.has(i))return i;let e=`${i}`,t=e.match(Vv);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${br(s)}e${r}`}return Ot(i,n)};function _r(i,e){return br(Ot(br(i/e))*e)}function Ql(i,e){return br(bi(br(i/e))*e)}function ug(i,e){return br(hi(br(i/e))*e)}function Ot(i,e=0){if(fg(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return vn(n)/t}var qs=new Map;function dg(i){return((""+i).split(".")[1]||"").length}function fa(i,e,t,n){let s=[],r=n.map(dg);for(let o=e;o<t;o++){let a=yn(o),l=Ot(so(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=i==10?h:Ot(h,d);s.push(u),qs.set(u,d)}}return s}var da={},wd=[],ro=[null,null],Xs=Array.isArray,fg=Number.isInteger,Gv=i=>i===void 0;function Om(i){return typeof i=="string"}function ec(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function Hv(i){return i!=null&&typeof i=="object"}var Wv=Object.getPrototypeOf(Uint8Array),pg="__proto__";function oo(i,e=ec){let t;if(Xs(i)){let n=i.find(s=>s!=null);if(Xs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=oo(i[s],e)}else t=i.slice()}else if(i instanceof Wv)t=i.slice();else if(e(i)){t={};for(let n in i)n!=pg&&(t[n]=oo(i[n],e))}else t=i;return t}function fn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=pg&&(ec(i[s])?fn(i[s],oo(n[s])):i[s]=oo(n[s]))}return i}var Xv=0,qv=1,Yv=2;function $v(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function Zv(i,e){if(jv(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Qv(o[0])||(o=Jv(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],d=Array(s).fill(void 0),u=e?e[o][c]:qv,p=[];for(let g=0;g<h.length;g++){let v=h[g],f=r.get(l[g]);v===null?u!=Xv&&(d[f]=v,u==Yv&&p.push(f)):d[f]=v}$v(d,p,s),n.push(d)}}return n}var Kv=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Jv(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function jv(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Qv(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Yn(1,hi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var mg=["January","February","March","April","May","June","July","August","September","October","November","December"],gg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function _g(i){return i.slice(0,3)}var ey=gg.map(_g),ty=mg.map(_g),ny={MMMM:mg,MMM:ty,WWWW:gg,WWW:ey};function aa(i){return(i<10?"0":"")+i}function iy(i){return(i<10?"00":i<100?"0":"")+i}var sy={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>aa(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>aa(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>aa(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>aa(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>aa(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>iy(i.getMilliseconds())};function Ed(i,e){e=e||ny;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?sy[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var ry=new Intl.DateTimeFormat().resolvedOptions().timeZone;function oy(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==ry?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var xg=i=>i%1==0,Kl=[1,2,2.5,5],ay=fa(10,-32,0,Kl),vg=fa(10,0,32,Kl),ly=vg.filter(xg),xr=ay.concat(vg),Td=`
`,yg="{YYYY}",km=Td+yg,bg="{M}/{D}",ha=Td+bg,Xl=ha+"/{YY}",Sg="{aa}",cy="{h}:{mm}",no=cy+Sg,Bm=Td+no,zm=":{ss}",At=null;function Mg(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?fa(10,0,3,Kl).filter(xg):fa(10,-3,0,Kl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,yg,At,At,At,At,At,At,1],[s*28,"{MMM}",km,At,At,At,At,At,1],[s,bg,km,At,At,At,At,At,1],[n,"{h}"+Sg,Xl,At,ha,At,At,At,1],[t,no,Xl,At,ha,At,At,At,1],[e,zm,Xl+" "+no,At,ha+" "+no,At,Bm,At,1],[i,zm+".{fff}",Xl+" "+no,At,ha+" "+no,At,Bm,At,1]];function h(d){return(u,p,g,v,f,m)=>{let y=[],A=f>=o,w=f>=r&&f<o,R=d(g),E=Ot(R*i,3),x=rd(R.getFullYear(),A?0:R.getMonth(),w||A?1:R.getDate()),T=Ot(x*i,3);if(w||A){let B=w?f/r:0,N=A?f/o:0,D=E==T?E:Ot(rd(x.getFullYear()+N,x.getMonth()+B,1)*i,3),W=new Date(vn(D/i)),H=W.getFullYear(),I=W.getMonth();for(let O=0;D<=v;O++){let q=rd(H+N*O,I+B*O,1),z=q-d(Ot(q*i,3));D=Ot((+q+z)*i,3),D<=v&&y.push(D)}}else{let B=f>=s?s:f,N=hi(g)-hi(E),D=T+N+Ql(E-T,B);y.push(D);let W=d(D),H=W.getHours()+W.getMinutes()/t+W.getSeconds()/n,I=f/n,O=u.axes[p]._space,q=m/O;for(;D=Ot(D+f,i==1?0:3),!(D>v);)if(I>1){let z=hi(Ot(H+I,6))%24,Q=d(D).getHours()-z;Q>1&&(Q=-1),D-=Q*n,H=(H+I)%24;let ie=y[y.length-1];Ot((D-ie)/f,3)*q>=.7&&y.push(D)}else y.push(D)}return y}}return[l,c,h]}var[hy,uy,dy]=Mg(1),[fy,py,my]=Mg(.001);fa(2,-53,53,[1]);function Vm(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Gm(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,d,u,p;return n.map(g=>{let v=i(g),f=v.getFullYear(),m=v.getMonth(),y=v.getDate(),A=v.getHours(),w=v.getMinutes(),R=v.getSeconds(),E=f!=l&&a[2]||m!=c&&a[3]||y!=h&&a[4]||A!=d&&a[5]||w!=u&&a[6]||R!=p&&a[7]||a[1];return l=f,c=m,h=y,d=A,u=w,p=R,E(v)})}}function gy(i,e){let t=Ed(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function rd(i,e,t){return new Date(i,e,t)}function Hm(i,e){return e(i)}var _y="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Wm(i,e){return(t,n,s,r)=>r==null?vd:e(i(n))}function xy(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function vy(i,e){return i.series[e].fill(i,e)}var yy={show:!0,live:!0,isolate:!1,mount:Bv,markers:{show:!0,width:2,stroke:xy,fill:vy,dash:"solid"},idx:null,idxs:null,values:[]};function by(i,e){let t=i.cursor.points,n=yi(),s=t.size(i,e);Wt(n,la,s),Wt(n,ca,s);let r=s/-2;Wt(n,"marginLeft",r),Wt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Wt(n,"borderWidth",o),n}function Sy(i,e){let t=i.series[e].points;return t._fill||t._stroke}function My(i,e){let t=i.series[e].points;return t._stroke||t._fill}function wy(i,e){return i.series[e].points.size}var od=[0,0];function Ey(i,e,t){return od[0]=e,od[1]=t,od}function ql(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function ad(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var Ty={show:!0,x:!0,y:!0,lock:!1,move:Ey,points:{one:!1,show:by,size:wy,width:0,stroke:My,fill:Sy},bind:{mousedown:ql,mouseup:ql,click:ql,dblclick:ql,mousemove:ad,mouseleave:ad,mouseenter:ad},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},wg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ad=fn({},wg,{filter:hg}),Eg=fn({},Ad,{size:10}),Tg=fn({},wg,{show:!1}),Cd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Ag="bold "+Cd,Cg=1.5,Xm={show:!0,scale:"x",stroke:xd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Ag,side:2,grid:Ad,ticks:Eg,border:Tg,font:Cd,lineGap:Cg,rotate:0},Ay="Value",Cy="Time",qm={show:!0,scale:"x",auto:!1,sorted:1,min:Ft,max:-Ft,idxs:[]};function Ry(i,e,t,n,s){return e.map(r=>r==null?"":Md(r))}function Py(i,e,t,n,s,r,o){let a=[],l=qs.get(s)||0;t=o?t:Ot(Ql(t,s),l);for(let c=t;c<=n;c=Ot(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function fd(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?xs:ag,h=hi(c(t));s=so(l,h),l==10&&(s=xr[Ui(s,xr)]);let d=t,u=s*l;l==10&&(u=xr[Ui(u,xr)]);do a.push(d),d=d+s,l==10&&!qs.has(d)&&(d=Ot(d,qs.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=xr[Ui(u,xr)]));while(d<=n);return a}function Iy(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?fd(i,e,Yn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?fd(i,e,Yn(l,-n),-t,s):[l]).reverse().map(u=>-u).concat(h,c)}var Rg=/./,Ly=/[12357]/,Dy=/[125]/,Ym=/1/,pd=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Ny(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),d=l(9,o)-h>=c?Rg:l(7,o)-h>=c?Ly:l(5,o)-h>=c?Dy:Ym;if(d==Ym){let u=yn(l(1,o)-h);if(u<c)return pd(e.slice().reverse(),a.distr,d,bi(c/u)).reverse()}return pd(e,a.distr,d,1)}function Uy(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=yn(l(1,o)-l(2,o));return c<a?pd(e.slice().reverse(),3,Rg,bi(a/c)).reverse():e}function Fy(i,e,t,n){return n==null?vd:e==null?"":Md(e)}var $m={show:!0,scale:"y",stroke:xd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Ag,side:3,grid:Ad,ticks:Eg,border:Tg,font:Cd,lineGap:Cg,rotate:0};function Oy(i,e){let t=3+(i||1)*2;return Ot(t*e,3)}function ky(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=yn(o-r),l=i.series[e],c=a/(l.points.space*Et);return n[1]-n[0]<=c}var Zm={scale:null,auto:!0,sorted:0,min:Ft,max:-Ft},Pg=(i,e,t,n,s)=>s,Km={show:!0,auto:!0,sorted:0,gaps:Pg,alpha:1,facets:[fn({},Zm,{scale:"x"}),fn({},Zm,{scale:"y"})]},Jm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Pg,alpha:1,points:{show:ky,filter:null},values:null,min:Ft,max:-Ft,idxs:[],path:null,clip:null};function By(i,e,t,n,s){return t/10}var Ig={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},zy=fn({},Ig,{time:!1,ori:1}),jm={};function Lg(i,e){let t=jm[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(jm[i]=t)),t}var ao=1,md=2;function Sr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],d=n==2?o[s.facets[1].scale]:o[s.scale],u=a.left,p=a.top,g=a.width,v=a.height,f=i.valToPosH,m=i.valToPosV;return h.ori==0?t(s,l,c,h,d,f,m,u,p,g,v,nc,co,sc,Ng,Fg):t(s,l,c,h,d,m,f,p,u,v,g,ic,ho,Id,Ug,Og)}function Rd(i,e){let t=0,n=0,s=Mt(i.bands,wd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function Vy(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function vs(i,e,t,n,s,r){return Sr(i,e,(o,a,l,c,h,d,u,p,g,v,f)=>{let m=o.pxRound,y=c.dir*(c.ori==0?1:-1),A=c.ori==0?co:ho,w,R;y==1?(w=t,R=n):(w=n,R=t);let E=m(d(a[w],c,v,p)),x=m(u(l[w],h,f,g)),T=m(d(a[R],c,v,p)),B=m(u(r==1?h.max:h.min,h,f,g)),N=new Path2D(s);return A(N,T,B),A(N,E,B),A(N,E,x),N})}function tc(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?sc:Id,l=t;for(let d=0;d<i.length;d++){let u=i[d];if(u[1]>u[0]){let p=u[0]-l;p>0&&a(o,l,n,p,n+r),l=u[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Gy(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Pd(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let d=c,u=c;if(s==1)for(;++c<=n&&e[c]===null;)u=c;else for(;--c>=t&&e[c]===null;)u=c;let p=r(i[d]),g=u==d?p:r(i[u]),v=d-s;p=o<=0&&v>=0&&v<l?r(i[v]):p;let m=u+s;g=o>=0&&m>=0&&m<l?r(i[m]):g,g>=p&&a.push([p,g])}return a}function Qm(i){return i==0?cg:i==1?vn:e=>_r(e,i)}function Dg(i){let e=i==0?nc:ic,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Fi(c,a/2,l/2),h=Fi(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var nc=(i,e,t)=>{i.moveTo(e,t)},ic=(i,e,t)=>{i.moveTo(t,e)},co=(i,e,t)=>{i.lineTo(e,t)},ho=(i,e,t)=>{i.lineTo(t,e)},sc=Dg(0),Id=Dg(1),Ng=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},Ug=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Fg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Og=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function kg(i){return(e,t,n,s,r)=>Sr(e,t,(o,a,l,c,h,d,u,p,g,v,f)=>{let{pxRound:m,points:y}=o,A,w;c.ori==0?(A=nc,w=Ng):(A=ic,w=Ug);let R=Ot(y.width*Et,3),E=(y.size-y.width)/2*Et,x=Ot(E*2,3),T=new Path2D,B=new Path2D,{left:N,top:D,width:W,height:H}=e.bbox;sc(B,N-x,D-x,W+x*2,H+x*2);let I=O=>{if(l[O]!=null){let q=m(d(a[O],c,v,p)),z=m(u(l[O],h,f,g));A(T,q+E,z),w(T,q,z,E,0,Yl*2)}};if(r)r.forEach(I);else for(let O=n;O<=s;O++)I(O);return{stroke:R>0?T:null,fill:T,clip:B,flags:ao|md}})}function Bg(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var Hy=Bg(co),Wy=Bg(ho);function zg(i){let e=Mt(i?.alignGaps,0);return(t,n,s,r)=>Sr(t,n,(o,a,l,c,h,d,u,p,g,v,f)=>{[s,r]=Jl(l,s,r);let m=o.pxRound,y=H=>m(d(H,c,v,p)),A=H=>m(u(H,h,f,g)),w,R;c.ori==0?(w=co,R=Hy):(w=ho,R=Wy);let E=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ao},T=x.stroke,B=!1;if(r-s>=v*4){let H=ue=>t.posToVal(ue,c.key,!0),I=null,O=null,q,z,le,K=y(a[E==1?s:r]),Q=y(a[s]),ie=y(a[r]),de=H(E==1?Q+1:ie-1);for(let ue=E==1?s:r;ue>=s&&ue<=r;ue+=E){let ee=a[ue],ge=(E==1?ee<de:ee>de)?K:y(ee),xe=l[ue];ge==K?xe!=null?(z=xe,I==null?(w(T,ge,A(z)),q=I=O=z):z<I?I=z:z>O&&(O=z)):xe===null&&(B=!0):(I!=null&&R(T,K,A(I),A(O),A(q),A(z)),xe!=null?(z=xe,w(T,ge,A(z)),I=O=q=z):(I=O=null,xe===null&&(B=!0)),K=ge,de=H(K+E))}I!=null&&I!=O&&le!=K&&R(T,K,A(I),A(O),A(q),A(z))}else for(let H=E==1?s:r;H>=s&&H<=r;H+=E){let I=l[H];I===null?B=!0:I!=null&&w(T,y(a[H]),A(I))}let[D,W]=Rd(t,n);if(o.fill!=null||D!=0){let H=x.fill=new Path2D(T),I=o.fillTo(t,n,o.min,o.max,D),O=A(I),q=y(a[s]),z=y(a[r]);E==-1&&([z,q]=[q,z]),w(H,z,O),w(H,q,O)}if(!o.spanGaps){let H=[];B&&H.push(...Pd(a,l,s,r,E,y,e)),x.gaps=H=o.gaps(t,n,s,r,H),x.clip=tc(H,c.ori,p,g,v,f)}return W!=0&&(x.band=W==2?[vs(t,n,s,r,T,-1),vs(t,n,s,r,T,1)]:vs(t,n,s,r,T,W)),x})}function Xy(i){let e=Mt(i.align,1),t=Mt(i.ascDesc,!1),n=Mt(i.alignGaps,0),s=Mt(i.extend,!1);return(r,o,a,l)=>Sr(r,o,(c,h,d,u,p,g,v,f,m,y,A)=>{[a,l]=Jl(d,a,l);let w=c.pxRound,{left:R,width:E}=r.bbox,x=Q=>w(g(Q,u,y,f)),T=Q=>w(v(Q,p,A,m)),B=u.ori==0?co:ho,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ao},D=N.stroke,W=u.dir*(u.ori==0?1:-1),H=T(d[W==1?a:l]),I=x(h[W==1?a:l]),O=I,q=I;s&&e==-1&&(q=R,B(D,q,H)),B(D,I,H);for(let Q=W==1?a:l;Q>=a&&Q<=l;Q+=W){let ie=d[Q];if(ie==null)continue;let de=x(h[Q]),ue=T(ie);e==1?B(D,de,H):B(D,O,ue),B(D,de,ue),H=ue,O=de}let z=O;s&&e==1&&(z=R+E,B(D,z,H));let[le,K]=Rd(r,o);if(c.fill!=null||le!=0){let Q=N.fill=new Path2D(D),ie=c.fillTo(r,o,c.min,c.max,le),de=T(ie);B(Q,z,de),B(Q,q,de)}if(!c.spanGaps){let Q=[];Q.push(...Pd(h,d,a,l,W,x,n));let ie=c.width*Et/2,de=t||e==1?ie:-ie,ue=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=de,ee[1]+=ue}),N.gaps=Q=c.gaps(r,o,a,l,Q),N.clip=tc(Q,u.ori,f,m,y,A)}return K!=0&&(N.band=K==2?[vs(r,o,a,l,D,-1),vs(r,o,a,l,D,1)]:vs(r,o,a,l,D,K)),N})}function eg(i,e,t,n,s,r,o=Ft){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=yn(i[l]-i[a]);h<c&&(c=h,o=yn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function qy(i){i=i||da;let e=Mt(i.size,[.6,Ft,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=xt(s),o=1-e[0],a=Mt(e[1],Ft),l=Mt(e[2],1),c=Mt(i.disp,da),h=Mt(i.each,p=>{}),{fill:d,stroke:u}=c;return(p,g,v,f)=>Sr(p,g,(m,y,A,w,R,E,x,T,B,N,D)=>{let W=m.pxRound,H=t,I=n*Et,O=a*Et,q=l*Et,z,le;w.ori==0?[z,le]=r(p,g):[le,z]=r(p,g);let K=w.dir*(w.ori==0?1:-1),Q=w.ori==0?sc:Id,ie=w.ori==0?h:(Re,Ye,ot,we,Ut,Ge,Xe)=>{h(Re,Ye,ot,Ut,we,Xe,Ge)},de=Mt(p.bands,wd).find(Re=>Re.series[0]==g),ue=de!=null?de.dir:0,ee=m.fillTo(p,g,m.min,m.max,ue),me=W(x(ee,R,D,B)),ge,xe,_e,Ve=N,$e=W(m.width*Et),Fe=!1,it=null,at=null,st=null,qt=null;d!=null&&($e==0||u!=null)&&(Fe=!0,it=d.values(p,g,v,f),at=new Map,new Set(it).forEach(Re=>{Re!=null&&at.set(Re,new Path2D)}),$e>0&&(st=u.values(p,g,v,f),qt=new Map,new Set(st).forEach(Re=>{Re!=null&&qt.set(Re,new Path2D)})));let{x0:kt,size:an}=c;if(kt!=null&&an!=null){H=1,y=kt.values(p,g,v,f),kt.unit==2&&(y=y.map(ot=>p.posToVal(T+ot*N,w.key,!0)));let Re=an.values(p,g,v,f);an.unit==2?xe=Re[0]*N:xe=E(Re[0],w,N,T)-E(0,w,N,T),Ve=eg(y,A,E,w,N,T,Ve),_e=Ve-xe+I}else Ve=eg(y,A,E,w,N,T,Ve),_e=Ve*o+I,xe=Ve-_e;_e<1&&(_e=0),$e>=xe/2&&($e=0),_e<5&&(W=cg);let Dt=_e>0,wn=Ve-_e-(Dt?$e:0);xe=W(dd(wn,q,O)),ge=(H==0?xe/2:H==K?0:xe)-H*K*((H==0?I/2:0)+(Dt?$e/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},_n=Fe?null:new Path2D,Jt=null;if(de!=null)Jt=p.data[de.series[1]];else{let{y0:Re,y1:Ye}=c;Re!=null&&Ye!=null&&(A=Ye.values(p,g,v,f),Jt=Re.values(p,g,v,f))}let ln=z*xe,F=le*xe;for(let Re=K==1?v:f;Re>=v&&Re<=f;Re+=K){let Ye=A[Re];if(Ye==null)continue;if(Jt!=null){let X=Jt[Re]??0;if(Ye-X==0)continue;me=x(X,R,D,B)}let ot=w.distr!=2||c!=null?y[Re]:Re,we=E(ot,w,N,T),Ut=x(Mt(Ye,ee),R,D,B),Ge=W(we-ge),Xe=W(Yn(Ut,me)),C=W(Fi(Ut,me)),b=Xe-C;if(Ye!=null){let X=Ye<0?F:ln,he=Ye<0?ln:F;Fe?($e>0&&st[Re]!=null&&Q(qt.get(st[Re]),Ge,C+hi($e/2),xe,Yn(0,b-$e),X,he),it[Re]!=null&&Q(at.get(it[Re]),Ge,C+hi($e/2),xe,Yn(0,b-$e),X,he)):Q(_n,Ge,C+hi($e/2),xe,Yn(0,b-$e),X,he),ie(p,g,Re,Ge-$e/2,C,xe+$e,b)}}return $e>0?bt.stroke=Fe?qt:_n:Fe||(bt._fill=m.width==0?m._fill:m._stroke??m._fill,bt.width=0),bt.fill=Fe?at:_n,bt})}function Yy(i,e){let t=Mt(e?.alignGaps,0);return(n,s,r,o)=>Sr(n,s,(a,l,c,h,d,u,p,g,v,f,m)=>{[r,o]=Jl(c,r,o);let y=a.pxRound,A=z=>y(u(z,h,f,g)),w=z=>y(p(z,d,m,v)),R,E,x;h.ori==0?(R=nc,x=co,E=Fg):(R=ic,x=ho,E=Og);let T=h.dir*(h.ori==0?1:-1),B=A(l[T==1?r:o]),N=B,D=[],W=[];for(let z=T==1?r:o;z>=r&&z<=o;z+=T)if(c[z]!=null){let K=l[z],Q=A(K);D.push(N=Q),W.push(w(c[z]))}let H={stroke:i(D,W,R,x,E,y),fill:null,clip:null,band:null,gaps:null,flags:ao},I=H.stroke,[O,q]=Rd(n,s);if(a.fill!=null||O!=0){let z=H.fill=new Path2D(I),le=a.fillTo(n,s,a.min,a.max,O),K=w(le);x(z,N,K),x(z,B,K)}if(!a.spanGaps){let z=[];z.push(...Pd(l,c,r,o,T,A,t)),H.gaps=z=a.gaps(n,s,r,o,z),H.clip=tc(z,h.ori,g,v,f,m)}return q!=0&&(H.band=q==2?[vs(n,s,r,o,I,-1),vs(n,s,r,o,I,1)]:vs(n,s,r,o,I,q)),H})}function $y(i){return Yy(Zy,i)}function Zy(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=e[u+1]-e[u],d[u]=i[u+1]-i[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,i[u]+d[u]/3,e[u]+l[u]*d[u]/3,i[u+1]-d[u]/3,e[u+1]-l[u+1]*d[u]/3,i[u+1],e[u+1])}return a}var gd=new Set;function tg(){for(let i of gd)i.syncRect(!0)}lo&&(yr(Rv,io,tg),yr(Pv,io,tg,!0),yr($l,io,()=>{Nn.pxRatio=Et}));var Ky=zg(),Jy=kg();function ng(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>_d(r,o,e,t))}function jy(i,e){return i.map((t,n)=>n==0?{}:fn({},e,t))}function _d(i,e,t,n){return fn({},e==0?t:n,i)}function Vg(i,e,t){return e==null?ro:[e,t]}var Qy=Vg;function eb(i,e,t){return e==null?ro:Zl(e,t,Sd,!0)}function Gg(i,e,t,n){return e==null?ro:jl(e,t,i.scales[n].log,!1)}var tb=Gg;function Hg(i,e,t,n){return e==null?ro:bd(e,t,i.scales[n].log,!1)}var nb=Hg;function ib(i,e,t,n,s){let r=Yn(Nm(i),Nm(e)),o=e-i,a=Ui(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?qs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function ig(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=vn((t=+s)*Et))+"px"),[i,e,t]}function sb(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Ot(e[2]*Et,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Nn(i,e,t){let n={mode:Mt(i.mode,1)},s=n.mode;function r(_,S,P,L){let V=S.valToPct(_);return L+P*(S.dir==-1?1-V:V)}function o(_,S,P,L){let V=S.valToPct(_);return L+P*(S.dir==-1?V:1-V)}function a(_,S,P,L){return S.ori==0?r(_,S,P,L):o(_,S,P,L)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=yi(uv);if(i.id!=null&&(c.id=i.id),ci(c,i.class),i.title){let _=yi(pv,c);_.textContent=i.title}let h=Ni("canvas"),d=n.ctx=h.getContext("2d"),u=yi(mv,c);yr("click",u,_=>{_.target===g&&(zt!=Xr||Yt!=qr)&&Dn.click(n,_)},!0);let p=n.under=yi(gv,u);u.appendChild(h);let g=n.over=yi(_v,u);i=oo(i);let v=+Mt(i.pxAlign,1),f=Qm(v);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let m=i.ms||.001,y=n.series=s==1?ng(i.series||[],qm,Jm,!1):jy(i.series||[null],Km),A=n.axes=ng(i.axes||[],Xm,$m,!0),w=n.scales={},R=n.bands=i.bands||[];R.forEach(_=>{_.fill=xt(_.fill||null),_.dir=Mt(_.dir,-1)});let E=s==2?y[1].facets[0].scale:y[0].scale,x={axes:gs,series:pt},T=(i.drawOrder||["axes","series"]).map(_=>x[_]);function B(_){let S=_.distr==3?P=>xs(P>0?P:_.clamp(n,P,_.min,_.max,_.key)):_.distr==4?P=>sd(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let L=S(P),{_min:V,_max:J}=_,ae=J-V;return(L-V)/ae}}function N(_){let S=w[_];if(S==null){let P=(i.scales||da)[_]||da;if(P.from!=null){N(P.from);let L=fn({},w[P.from],P,{key:_});L.valToPct=B(L),w[_]=L}else{S=w[_]=fn({},_==E?Ig:zy,P),S.key=_;let L=S.time,V=S.range,J=Xs(V);if((_!=E||s==2&&!L)&&(J&&(V[0]==null||V[1]==null)&&(V={min:V[0]==null?Im:{mode:1,hard:V[0],soft:V[0]},max:V[1]==null?Im:{mode:1,hard:V[1],soft:V[1]}},J=!1),!J&&ec(V))){let ae=V;V=(fe,Se,De)=>Se==null?ro:Zl(Se,De,ae)}S.range=xt(V||(L?Qy:_==E?S.distr==3?tb:S.distr==4?nb:Vg:S.distr==3?Gg:S.distr==4?Hg:eb)),S.auto=xt(J?!1:S.auto),S.clamp=xt(S.clamp||By),S._min=S._max=null,S.valToPct=B(S)}}}N("x"),N("y"),s==1&&y.forEach(_=>{N(_.scale)}),A.forEach(_=>{N(_.scale)});for(let _ in i.scales)N(_);let D=w[E],W=D.distr,H,I;D.ori==0?(ci(c,dv),H=r,I=o):(ci(c,fv),H=o,I=r);let O={};for(let _ in w){let S=w[_];(S.min!=null||S.max!=null)&&(O[_]={min:S.min,max:S.max},S.min=S.max=null)}let q=i.tzDate||(_=>new Date(vn(_/m))),z=i.fmtDate||Ed,le=m==1?dy(q):my(q),K=Gm(q,Vm(m==1?uy:py,z)),Q=Wm(q,Hm(_y,z)),ie=[],de=n.legend=fn({},yy,i.legend),ue=n.cursor=fn({},Ty,{drag:{y:s==2}},i.cursor),ee=de.show,me=ue.show,ge=de.markers;de.idxs=ie,ge.width=xt(ge.width),ge.dash=xt(ge.dash),ge.stroke=xt(ge.stroke),ge.fill=xt(ge.fill);let xe,_e,Ve,$e=[],Fe=[],it,at=!1,st={};if(de.live){let _=y[1]?y[1].values:null;at=_!=null,it=at?_(n,1,0):{_:0};for(let S in it)st[S]=vd}if(ee)if(xe=Ni("table",Mv,c),Ve=Ni("tbody",null,xe),de.mount(n,xe),at){_e=Ni("thead",null,xe,Ve);let _=Ni("tr",null,_e);Ni("th",null,_);for(var qt in it)Ni("th",xm,_).textContent=qt}else ci(xe,Ev),de.live&&ci(xe,wv);let kt={show:!0},an={show:!1};function Dt(_,S){if(S==0&&(at||!de.live||s==2))return ro;let P=[],L=Ni("tr",Tv,Ve,Ve.childNodes[S]);ci(L,_.class),_.show||ci(L,vr);let V=Ni("th",null,L);if(ge.show){let fe=yi(Av,V);if(S>0){let Se=ge.width(n,S);Se&&(fe.style.border=Se+"px "+ge.dash(n,S)+" "+ge.stroke(n,S)),fe.style.background=ge.fill(n,S)}}let J=yi(xm,V);_.label instanceof HTMLElement?J.appendChild(_.label):J.textContent=_.label,S>0&&(ge.show||(J.style.color=_.width>0?ge.stroke(n,S):ge.fill(n,S)),bt("click",V,fe=>{if(ue._lock)return;Ke(fe);let Se=y.indexOf(_);if((fe.ctrlKey||fe.metaKey)!=de.isolate){let De=y.some((Ne,Oe)=>Oe>0&&Oe!=Se&&Ne.show);y.forEach((Ne,Oe)=>{Oe>0&&Zi(Oe,De?Oe==Se?kt:an:kt,!0,dn.setSeries)})}else Zi(Se,{show:!_.show},!0,dn.setSeries)},!1),Je&&bt(Sm,V,fe=>{ue._lock||(Ke(fe),Zi(y.indexOf(_),$r,!0,dn.setSeries))},!1));for(var ae in it){let fe=Ni("td",Cv,L);fe.textContent="--",P.push(fe)}return[L,P]}let wn=new Map;function bt(_,S,P,L=!0){let V=wn.get(S)||{},J=ue.bind[_](n,S,P,L);J&&(yr(_,S,V[_]=J),wn.set(S,V))}function _n(_,S,P){let L=wn.get(S)||{};for(let V in L)(_==null||V==_)&&(ud(V,S,L[V]),delete L[V]);_==null&&wn.delete(S)}let Jt=0,ln=0,F=0,Re=0,Ye=0,ot=0,we=Ye,Ut=ot,Ge=F,Xe=Re,C=0,b=0,X=0,he=0;n.bbox={};let oe=!1,ye=!1,be=!1,te=!1,se=!1,pe=!1;function U(_,S,P){(P||_!=n.width||S!=n.height)&&re(_,S),ht(!1),be=!0,ye=!0,On()}function re(_,S){n.width=Jt=F=_,n.height=ln=Re=S,Ye=ot=0,Me(),He();let P=n.bbox;C=P.left=_r(Ye*Et,.5),b=P.top=_r(ot*Et,.5),X=P.width=_r(F*Et,.5),he=P.height=_r(Re*Et,.5)}let ne=3;function Ee(){let _=!1,S=0;for(;!_;){S++;let P=Gr(S),L=$i(S);_=S==ne||P&&L,_||(re(n.width,n.height),ye=!0)}}function ve({width:_,height:S}){U(_,S)}n.setSize=ve;function Me(){let _=!1,S=!1,P=!1,L=!1;A.forEach((V,J)=>{if(V.show&&V._show){let{side:ae,_size:fe}=V,Se=ae%2,De=V.label!=null?V.labelSize:0,Ne=fe+De;Ne>0&&(Se?(F-=Ne,ae==3?(Ye+=Ne,L=!0):P=!0):(Re-=Ne,ae==0?(ot+=Ne,_=!0):S=!0))}}),qi[0]=_,qi[1]=P,qi[2]=S,qi[3]=L,F-=Ai[1]+Ai[3],Ye+=Ai[3],Re-=Ai[2]+Ai[0],ot+=Ai[0]}function He(){let _=Ye+F,S=ot+Re,P=Ye,L=ot;function V(J,ae){switch(J){case 1:return _+=ae,_-ae;case 2:return S+=ae,S-ae;case 3:return P-=ae,P+ae;case 0:return L-=ae,L+ae}}A.forEach((J,ae)=>{if(J.show&&J._show){let fe=J.side;J._pos=V(fe,J._size),J.label!=null&&(J._lpos=V(fe,J.labelSize))}})}if(ue.dataIdx==null){let _=ue.hover,S=_.skip=new Set(_.skip??[]);S.add(void 0);let P=_.prox=xt(_.prox),L=_.bias??=0;ue.dataIdx=(V,J,ae,fe)=>{if(J==0)return ae;let Se=ae,De=P(V,J,ae,fe)??Ft,Ne=De>=0&&De<Ft,Oe=D.ori==0?F:Re,rt=ue.left,wt=e[0],St=e[J];if(S.has(St[ae])){Se=null;let gt=null,Ze=null,We;if(L==0||L==-1)for(We=ae;gt==null&&We-- >0;)S.has(St[We])||(gt=We);if(L==0||L==1)for(We=ae;Ze==null&&We++<St.length;)S.has(St[We])||(Ze=We);if(gt!=null||Ze!=null)if(Ne){let Gt=gt==null?-1/0:H(wt[gt],D,Oe,0),en=Ze==null?1/0:H(wt[Ze],D,Oe,0),Cn=rt-Gt,Nt=en-rt;Cn<=Nt?Cn<=De&&(Se=gt):Nt<=De&&(Se=Ze)}else Se=Ze==null?gt:gt==null?Ze:ae-gt<=Ze-ae?gt:Ze}else Ne&&yn(rt-H(wt[ae],D,Oe,0))>De&&(Se=null);return Se}}let Ke=_=>{ue.event=_};ue.idxs=ie,ue._lock=!1;let ce=ue.points;ce.show=xt(ce.show),ce.size=xt(ce.size),ce.stroke=xt(ce.stroke),ce.width=xt(ce.width),ce.fill=xt(ce.fill);let ke=n.focus=fn({},i.focus||{alpha:.3},ue.focus),Je=ke.prox>=0,Ce=Je&&ce.one,lt=[],Bt=[],Vn=[];function Zo(_,S){let P=ce.show(n,S);if(P instanceof HTMLElement)return ci(P,Sv),ci(P,_.class),ts(P,-10,-10,F,Re),g.insertBefore(P,lt[S]),P}function Br(_,S){if(s==1||S>0){let P=s==1&&w[_.scale].time,L=_.value;_.value=P?Om(L)?Wm(q,Hm(L,z)):L||Q:L||Fy,_.label=_.label||(P?Cy:Ay)}if(Ce||S>0){_.width=_.width==null?1:_.width,_.paths=_.paths||Ky||zv,_.fillTo=xt(_.fillTo||Vy),_.pxAlign=+Mt(_.pxAlign,v),_.pxRound=Qm(_.pxAlign),_.stroke=xt(_.stroke||null),_.fill=xt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=Oy(Yn(1,_.width),1),L=_.points=fn({},{size:P,width:Yn(1,P*.2),stroke:_.stroke,space:P*2,paths:Jy,_stroke:null,_fill:null},_.points);L.show=xt(L.show),L.filter=xt(L.filter),L.fill=xt(L.fill),L.stroke=xt(L.stroke),L.paths=xt(L.paths),L.pxAlign=_.pxAlign}if(ee){let P=Dt(_,S);$e.splice(S,0,P[0]),Fe.splice(S,0,P[1]),de.values.push(null)}if(me){ie.splice(S,0,null);let P=null;Ce?S==0&&(P=Zo(_,S)):S>0&&(P=Zo(_,S)),lt.splice(S,0,P),Bt.splice(S,0,0),Vn.splice(S,0,0)}An("addSeries",S)}function Iu(_,S){S=S??y.length,_=s==1?_d(_,S,qm,Jm):_d(_,S,{},Km),y.splice(S,0,_),Br(y[S],S)}n.addSeries=Iu;function dl(_){if(y.splice(_,1),ee){de.values.splice(_,1),Fe.splice(_,1);let S=$e.splice(_,1)[0];_n(null,S.firstChild),S.remove()}me&&(ie.splice(_,1),lt.splice(_,1)[0].remove(),Bt.splice(_,1),Vn.splice(_,1)),An("delSeries",_)}n.delSeries=dl;let qi=[!1,!1,!1,!1];function fs(_,S){if(_._show=_.show,_.show){let P=_.side%2,L=w[_.scale];L==null&&(_.scale=P?y[1].scale:E,L=w[_.scale]);let V=L.time;_.size=xt(_.size),_.space=xt(_.space),_.rotate=xt(_.rotate),Xs(_.incrs)&&_.incrs.forEach(ae=>{!qs.has(ae)&&qs.set(ae,dg(ae))}),_.incrs=xt(_.incrs||(L.distr==2?ly:V?m==1?hy:fy:xr)),_.splits=xt(_.splits||(V&&L.distr==1?le:L.distr==3?fd:L.distr==4?Iy:Py)),_.stroke=xt(_.stroke),_.grid.stroke=xt(_.grid.stroke),_.ticks.stroke=xt(_.ticks.stroke),_.border.stroke=xt(_.border.stroke);let J=_.values;_.values=Xs(J)&&!Xs(J[0])?xt(J):V?Xs(J)?Gm(q,Vm(J,z)):Om(J)?gy(q,J):J||K:J||Ry,_.filter=xt(_.filter||(L.distr>=3&&L.log==10?Ny:L.distr==3&&L.log==2?Uy:hg)),_.font=ig(_.font),_.labelFont=ig(_.labelFont),_._size=_.size(n,null,S,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(qi[S]=!0,_._el=yi(xv,u))}}function ps(_,S,P,L){let[V,J,ae,fe]=P,Se=S%2,De=0;return Se==0&&(fe||J)&&(De=S==0&&!V||S==2&&!ae?vn(Xm.size/3):0),Se==1&&(V||ae)&&(De=S==1&&!J||S==3&&!fe?vn($m.size/2):0),De}let Ko=n.padding=(i.padding||[ps,ps,ps,ps]).map(_=>xt(Mt(_,ps))),Ai=n._padding=Ko.map((_,S)=>_(n,S,qi,0)),jt,sn=null,rn=null,Yi=s==1?y[0].idxs:null,ri=null,Fs=!1;function Jo(_,S){if(e=_??[],n.data=n._data=e,s==2){jt=0;for(let P=1;P<y.length;P++)jt+=e[P][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ri=e[0],jt=ri.length;let P=e;if(W==2){P=e.slice();let L=P[0]=Array(jt);for(let V=0;V<jt;V++)L[V]=V}n._data=e=P}if(ht(!0),An("setData"),W==2&&(be=!0),S!==!1){let P=D;P.auto(n,Fs)?jo():Bs(E,P.min,P.max),te=te||ue.left>=0,pe=!0,On()}}n.setData=Jo;function jo(){Fs=!0;let _,S;s==1&&(jt>0?(sn=Yi[0]=0,rn=Yi[1]=jt-1,_=e[0][sn],S=e[0][rn],W==2?(_=sn,S=rn):_==S&&(W==3?[_,S]=jl(_,_,D.log,!1):W==4?[_,S]=bd(_,_,D.log,!1):D.time?S=_+vn(86400/m):[_,S]=Zl(_,S,Sd,!0))):(sn=Yi[0]=_=null,rn=Yi[1]=S=null)),Bs(E,_,S)}let zr,Os,Vr,M,k,j,$,Z,Te,Pe;function Ae(_,S,P,L,V,J){_??=ym,P??=wd,L??="butt",V??=ym,J??="round",_!=zr&&(d.strokeStyle=zr=_),V!=Os&&(d.fillStyle=Os=V),S!=Vr&&(d.lineWidth=Vr=S),J!=k&&(d.lineJoin=k=J),L!=j&&(d.lineCap=j=L),P!=M&&d.setLineDash(M=P)}function Ie(_,S,P,L){S!=Os&&(d.fillStyle=Os=S),_!=$&&(d.font=$=_),P!=Z&&(d.textAlign=Z=P),L!=Te&&(d.textBaseline=Te=L)}function ze(_,S,P,L,V=0){if(L.length>0&&_.auto(n,Fs)&&(S==null||S.min==null)){let J=Mt(sn,0),ae=Mt(rn,L.length-1),fe=P.min==null?Nv(L,J,ae,V,_.distr==3):[P.min,P.max];_.min=Fi(_.min,P.min=fe[0]),_.max=Yn(_.max,P.max=fe[1])}}let Qe={min:null,max:null};function ft(){for(let L in w){let V=w[L];O[L]==null&&(V.min==null||O[E]!=null&&V.auto(n,Fs))&&(O[L]=Qe)}for(let L in w){let V=w[L];O[L]==null&&V.from!=null&&O[V.from]!=null&&(O[L]=Qe)}O[E]!=null&&ht(!0);let _={};for(let L in O){let V=O[L];if(V!=null){let J=_[L]=oo(w[L],Hv);if(V.min!=null)fn(J,V);else if(L!=E||s==2)if(jt==0&&J.from==null){let ae=J.range(n,null,null,L);J.min=ae[0],J.max=ae[1]}else J.min=Ft,J.max=-Ft}}if(jt>0){y.forEach((L,V)=>{if(s==1){let J=L.scale,ae=O[J];if(ae==null)return;let fe=_[J];if(V==0){let Se=fe.range(n,fe.min,fe.max,J);fe.min=Se[0],fe.max=Se[1],sn=Ui(fe.min,e[0]),rn=Ui(fe.max,e[0]),rn-sn>1&&(e[0][sn]<fe.min&&sn++,e[0][rn]>fe.max&&rn--),L.min=ri[sn],L.max=ri[rn]}else L.show&&L.auto&&ze(fe,ae,L,e[V],L.sorted);L.idxs[0]=sn,L.idxs[1]=rn}else if(V>0&&L.show&&L.auto){let[J,ae]=L.facets,fe=J.scale,Se=ae.scale,[De,Ne]=e[V],Oe=_[fe],rt=_[Se];Oe!=null&&ze(Oe,O[fe],J,De,J.sorted),rt!=null&&ze(rt,O[Se],ae,Ne,ae.sorted),L.min=ae.min,L.max=ae.max}});for(let L in _){let V=_[L],J=O[L];if(V.from==null&&(J==null||J.min==null)){let ae=V.range(n,V.min==Ft?null:V.min,V.max==-Ft?null:V.max,L);V.min=ae[0],V.max=ae[1]}}}for(let L in _){let V=_[L];if(V.from!=null){let J=_[V.from];if(J.min==null)V.min=V.max=null;else{let ae=V.range(n,J.min,J.max,L);V.min=ae[0],V.max=ae[1]}}}let S={},P=!1;for(let L in _){let V=_[L],J=w[L];if(J.min!=V.min||J.max!=V.max){J.min=V.min,J.max=V.max;let ae=J.distr;J._min=ae==3?xs(J.min):ae==4?sd(J.min,J.asinh):ae==100?J.fwd(J.min):J.min,J._max=ae==3?xs(J.max):ae==4?sd(J.max,J.asinh):ae==100?J.fwd(J.max):J.max,S[L]=P=!0}}if(P){y.forEach((L,V)=>{s==2?V>0&&S.y&&(L._paths=null):S[L.scale]&&(L._paths=null)});for(let L in S)be=!0,An("setScale",L);me&&ue.left>=0&&(te=pe=!0)}for(let L in O)O[L]=null}function Be(_){let S=dd(sn-1,0,jt-1),P=dd(rn+1,0,jt-1);for(;_[S]==null&&S>0;)S--;for(;_[P]==null&&P<jt-1;)P++;return[S,P]}function pt(){if(jt>0){let _=y.some(S=>S._focus)&&Pe!=ke.alpha;_&&(d.globalAlpha=Pe=ke.alpha),y.forEach((S,P)=>{if(P>0&&S.show&&(Zt(P,!1),Zt(P,!0),S._paths==null)){let L=Pe;Pe!=S.alpha&&(d.globalAlpha=Pe=S.alpha);let V=s==2?[0,e[P][0].length-1]:Be(e[P]);S._paths=S.paths(n,P,V[0],V[1]),Pe!=L&&(d.globalAlpha=Pe=L)}}),y.forEach((S,P)=>{if(P>0&&S.show){let L=Pe;Pe!=S.alpha&&(d.globalAlpha=Pe=S.alpha),S._paths!=null&&Pt(P,!1);{let V=S._paths!=null?S._paths.gaps:null,J=S.points.show(n,P,sn,rn,V),ae=S.points.filter(n,P,J,V);(J||ae)&&(S.points._paths=S.points.paths(n,P,sn,rn,ae),Pt(P,!0))}Pe!=L&&(d.globalAlpha=Pe=L),An("drawSeries",P)}}),_&&(d.globalAlpha=Pe=1)}}function Zt(_,S){let P=S?y[_].points:y[_];P._stroke=P.stroke(n,_),P._fill=P.fill(n,_)}function Pt(_,S){let P=S?y[_].points:y[_],{stroke:L,fill:V,clip:J,flags:ae,_stroke:fe=P._stroke,_fill:Se=P._fill,_width:De=P.width}=P._paths;De=Ot(De*Et,3);let Ne=null,Oe=De%2/2;S&&Se==null&&(Se=De>0?"#fff":fe);let rt=P.pxAlign==1&&Oe>0;if(rt&&d.translate(Oe,Oe),!S){let wt=C-De/2,St=b-De/2,gt=X+De,Ze=he+De;Ne=new Path2D,Ne.rect(wt,St,gt,Ze)}S?Ue(fe,De,P.dash,P.cap,Se,L,V,ae,J):It(_,fe,De,P.dash,P.cap,Se,L,V,ae,Ne,J),rt&&d.translate(-Oe,-Oe)}function It(_,S,P,L,V,J,ae,fe,Se,De,Ne){let Oe=!1;Se!=0&&R.forEach((rt,wt)=>{if(rt.series[0]==_){let St=y[rt.series[1]],gt=e[rt.series[1]],Ze=(St._paths||da).band;Xs(Ze)&&(Ze=rt.dir==1?Ze[0]:Ze[1]);let We,Gt=null;St.show&&Ze&&Fv(gt,sn,rn)?(Gt=rt.fill(n,wt)||J,We=St._paths.clip):Ze=null,Ue(S,P,L,V,Gt,ae,fe,Se,De,Ne,We,Ze),Oe=!0}}),Oe||Ue(S,P,L,V,J,ae,fe,Se,De,Ne)}let xn=ao|md;function Ue(_,S,P,L,V,J,ae,fe,Se,De,Ne,Oe){Ae(_,S,P,L,V),(Se||De||Oe)&&(d.save(),Se&&d.clip(Se),De&&d.clip(De)),Oe?(fe&xn)==xn?(d.clip(Oe),Ne&&d.clip(Ne),_t(V,ae),cn(_,J,S)):fe&md?(_t(V,ae),d.clip(Oe),cn(_,J,S)):fe&ao&&(d.save(),d.clip(Oe),Ne&&d.clip(Ne),_t(V,ae),d.restore(),cn(_,J,S)):(_t(V,ae),cn(_,J,S)),(Se||De||Oe)&&d.restore()}function cn(_,S,P){P>0&&(S instanceof Map?S.forEach((L,V)=>{d.strokeStyle=zr=V,d.stroke(L)}):S!=null&&_&&d.stroke(S))}function _t(_,S){S instanceof Map?S.forEach((P,L)=>{d.fillStyle=Os=L,d.fill(P)}):S!=null&&_&&d.fill(S)}function ms(_,S,P,L){let V=A[_],J;if(L<=0)J=[0,0];else{let ae=V._space=V.space(n,_,S,P,L),fe=V._incrs=V.incrs(n,_,S,P,L,ae);J=ib(S,P,fe,L,ae)}return V._found=J}function hn(_,S,P,L,V,J,ae,fe,Se,De){let Ne=ae%2/2;v==1&&d.translate(Ne,Ne),Ae(fe,ae,Se,De,fe),d.beginPath();let Oe,rt,wt,St,gt=V+(L==0||L==3?-J:J);P==0?(rt=V,St=gt):(Oe=V,wt=gt);for(let Ze=0;Ze<_.length;Ze++)S[Ze]!=null&&(P==0?Oe=wt=_[Ze]:rt=St=_[Ze],d.moveTo(Oe,rt),d.lineTo(wt,St));d.stroke(),v==1&&d.translate(-Ne,-Ne)}function Gr(_){let S=!0;return A.forEach((P,L)=>{if(!P.show)return;let V=w[P.scale];if(V.min==null){P._show&&(S=!1,P._show=!1,ht(!1));return}else P._show||(S=!1,P._show=!0,ht(!1));let J=P.side,ae=J%2,{min:fe,max:Se}=V,[De,Ne]=ms(L,fe,Se,ae==0?F:Re);if(Ne==0)return;let Oe=V.distr==2,rt=P._splits=P.splits(n,L,fe,Se,De,Ne,Oe),wt=V.distr==2?rt.map(We=>ri[We]):rt,St=V.distr==2?ri[rt[1]]-ri[rt[0]]:De,gt=P._values=P.values(n,P.filter(n,wt,L,Ne,St),L,Ne,St);P._rotate=J==2?P.rotate(n,gt,L,Ne):0;let Ze=P._size;P._size=bi(P.size(n,gt,L,_)),Ze!=null&&P._size!=Ze&&(S=!1)}),S}function $i(_){let S=!0;return Ko.forEach((P,L)=>{let V=P(n,L,qi,_);V!=Ai[L]&&(S=!1),Ai[L]=V}),S}function gs(){for(let _=0;_<A.length;_++){let S=A[_];if(!S.show||!S._show)continue;let P=S.side,L=P%2,V,J,ae=S.stroke(n,_),fe=P==0||P==3?-1:1,[Se,De]=S._found;if(S.label!=null){let Wn=S.labelGap*fe,li=vn((S._lpos+Wn)*Et);Ie(S.labelFont[0],ae,"center",P==2?"top":vm),d.save(),L==1?(V=J=0,d.translate(li,vn(b+he/2)),d.rotate((P==3?-Yl:Yl)/2)):(V=vn(C+X/2),J=li);let mr=lg(S.label)?S.label(n,_,Se,De):S.label;d.fillText(mr,V,J),d.restore()}if(De==0)continue;let Ne=w[S.scale],Oe=L==0?X:he,rt=L==0?C:b,wt=S._splits,St=Ne.distr==2?wt.map(Wn=>ri[Wn]):wt,gt=Ne.distr==2?ri[wt[1]]-ri[wt[0]]:Se,Ze=S.ticks,We=S.border,Gt=Ze.show?Ze.size:0,en=vn(Gt*Et),Cn=vn((S.alignTo==2?S._size-Gt-S.gap:S.gap)*Et),Nt=S._rotate*-Yl/180,tn=f(S._pos*Et),oi=(en+Cn)*fe,Hn=tn+oi;J=L==0?Hn:0,V=L==1?Hn:0;let _i=S.font[0],Ci=S.align==1?to:S.align==2?td:Nt>0?to:Nt<0?td:L==0?"center":P==3?td:to,Ji=Nt||L==1?"middle":P==2?"top":vm;Ie(_i,ae,Ci,Ji);let ai=S.font[1]*S.lineGap,xi=wt.map(Wn=>f(a(Wn,Ne,Oe,rt))),Ri=S._values;for(let Wn=0;Wn<Ri.length;Wn++){let li=Ri[Wn];if(li!=null){L==0?V=xi[Wn]:J=xi[Wn],li=""+li;let mr=li.indexOf(`
`)==-1?[li]:li.split(/\n/gm);for(let Xn=0;Xn<mr.length;Xn++){let Yp=mr[Xn];Nt?(d.save(),d.translate(V,J+Xn*ai),d.rotate(Nt),d.fillText(Yp,0,0),d.restore()):d.fillText(Yp,V,J+Xn*ai)}}}Ze.show&&hn(xi,Ze.filter(n,St,_,De,gt),L,P,tn,en,Ot(Ze.width*Et,3),Ze.stroke(n,_),Ze.dash,Ze.cap);let ji=S.grid;ji.show&&hn(xi,ji.filter(n,St,_,De,gt),L,L==0?2:1,L==0?b:C,L==0?he:X,Ot(ji.width*Et,3),ji.stroke(n,_),ji.dash,ji.cap),We.show&&hn([tn],[1],L==0?1:0,L==0?1:2,L==1?b:C,L==1?he:X,Ot(We.width*Et,3),We.stroke(n,_),We.dash,We.cap)}An("drawAxes")}function ht(_){y.forEach((S,P)=>{P>0&&(S._paths=null,_&&(s==1?(S.min=null,S.max=null):S.facets.forEach(L=>{L.min=null,L.max=null})))})}let Qt=!1,Gn=!1,Lt=[];function un(){Gn=!1;for(let _=0;_<Lt.length;_++)An(...Lt[_]);Lt.length=0}function On(){Qt||(Kv(Rp),Qt=!0)}function fl(_,S=!1){Qt=!0,Gn=S,_(n),Rp(),S&&Lt.length>0&&queueMicrotask(un)}n.batch=fl;function Rp(){if(oe&&(ft(),oe=!1),be&&(Ee(),be=!1),ye){if(Wt(p,to,Ye),Wt(p,"top",ot),Wt(p,la,F),Wt(p,ca,Re),Wt(g,to,Ye),Wt(g,"top",ot),Wt(g,la,F),Wt(g,ca,Re),Wt(u,la,Jt),Wt(u,ca,ln),h.width=vn(Jt*Et),h.height=vn(ln*Et),A.forEach(({_el:_,_show:S,_size:P,_pos:L,side:V})=>{if(_!=null)if(S){let J=V===3||V===0?P:0,ae=V%2==1;Wt(_,ae?"left":"top",L-J),Wt(_,ae?"width":"height",P),Wt(_,ae?"top":"left",ae?ot:Ye),Wt(_,ae?"height":"width",ae?Re:F),hd(_,vr)}else ci(_,vr)}),zr=Os=Vr=k=j=$=Z=Te=M=null,Pe=1,ta(!0),Ye!=we||ot!=Ut||F!=Ge||Re!=Xe){ht(!1);let _=F/Ge,S=Re/Xe;if(me&&!te&&ue.left>=0){ue.left*=_,ue.top*=S,Hr&&ts(Hr,vn(ue.left),0,F,Re),Wr&&ts(Wr,0,vn(ue.top),F,Re);for(let P=0;P<lt.length;P++){let L=lt[P];L!=null&&(Bt[P]*=_,Vn[P]*=S,ts(L,bi(Bt[P]),bi(Vn[P]),F,Re))}}if(Vt.show&&!se&&Vt.left>=0&&Vt.width>0){Vt.left*=_,Vt.width*=_,Vt.top*=S,Vt.height*=S;for(let P in Ou)Wt(Yr,P,Vt[P])}we=Ye,Ut=ot,Ge=F,Xe=Re}An("setSize"),ye=!1}Jt>0&&ln>0&&(d.clearRect(0,0,h.width,h.height),An("drawClear"),T.forEach(_=>_()),An("draw")),Vt.show&&se&&(pl(Vt),se=!1),me&&te&&(pr(null,!0,!1),te=!1),de.show&&de.live&&pe&&(Uu(),pe=!1),l||(l=!0,n.status=1,An("ready")),Fs=!1,Qt=!1}n.redraw=(_,S)=>{be=S||!1,_!==!1?Bs(E,D.min,D.max):On()};function Lu(_,S){let P=w[_];if(P.from==null){if(jt==0){let L=P.range(n,S.min,S.max,_);S.min=L[0],S.max=L[1]}if(S.min>S.max){let L=S.min;S.min=S.max,S.max=L}if(jt>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;_==E&&P.distr==2&&jt>0&&(S.min=Ui(S.min,e[0]),S.max=Ui(S.max,e[0]),S.min==S.max&&S.max++),O[_]=S,oe=!0,On()}}n.setScale=Lu;let Du,Nu,Hr,Wr,Pp,Ip,Xr,qr,Lp,Dp,zt,Yt,ks=!1,Dn=ue.drag,En=Dn.x,Tn=Dn.y;me&&(ue.x&&(Du=yi(yv,g)),ue.y&&(Nu=yi(bv,g)),D.ori==0?(Hr=Du,Wr=Nu):(Hr=Nu,Wr=Du),zt=ue.left,Yt=ue.top);let Vt=n.select=fn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Yr=Vt.show?yi(vv,Vt.over?g:p):null;function pl(_,S){if(Vt.show){for(let P in _)Vt[P]=_[P],P in Ou&&Wt(Yr,P,_[P]);S!==!1&&An("setSelect")}}n.setSelect=pl;function Tx(_){if(y[_].show)ee&&hd($e[_],vr);else if(ee&&ci($e[_],vr),me){let P=Ce?lt[0]:lt[_];P!=null&&ts(P,-10,-10,F,Re)}}function Bs(_,S,P){Lu(_,{min:S,max:P})}function Zi(_,S,P,L){S.focus!=null&&Ix(_),S.show!=null&&y.forEach((V,J)=>{J>0&&(_==J||_==null)&&(V.show=S.show,Tx(J),s==2?(Bs(V.facets[0].scale,null,null),Bs(V.facets[1].scale,null,null)):Bs(V.scale,null,null),On())}),P!==!1&&An("setSeries",_,S),L&&na("setSeries",n,_,S)}n.setSeries=Zi;function Ax(_,S){fn(R[_],S)}function Cx(_,S){_.fill=xt(_.fill||null),_.dir=Mt(_.dir,-1),S=S??R.length,R.splice(S,0,_)}function Rx(_){_==null?R.length=0:R.splice(_,1)}n.addBand=Cx,n.setBand=Ax,n.delBand=Rx;function Px(_,S){y[_].alpha=S,me&&lt[_]!=null&&(lt[_].style.opacity=S),ee&&$e[_]&&($e[_].style.opacity=S)}let _s,zs,fr,$r={focus:!0};function Ix(_){if(_!=fr){let S=_==null,P=ke.alpha!=1;y.forEach((L,V)=>{if(s==1||V>0){let J=S||V==0||V==_;L._focus=S?null:J,P&&Px(V,J?1:ke.alpha)}}),fr=_,P&&On()}}ee&&Je&&bt(Mm,xe,_=>{ue._lock||(Ke(_),fr!=null&&Zi(null,$r,!0,dn.setSeries))});function Ki(_,S,P){let L=w[S];P&&(_=_/Et-(L.ori==1?ot:Ye));let V=F;L.ori==1&&(V=Re,_=V-_),L.dir==-1&&(_=V-_);let J=L._min,ae=L._max,fe=_/V,Se=J+(ae-J)*fe,De=L.distr;return De==3?so(10,Se):De==4?kv(Se,L.asinh):De==100?L.bwd(Se):Se}function Lx(_,S){let P=Ki(_,E,S);return Ui(P,e[0],sn,rn)}n.valToIdx=_=>Ui(_,e[0]),n.posToIdx=Lx,n.posToVal=Ki,n.valToPos=(_,S,P)=>w[S].ori==0?r(_,w[S],P?X:F,P?C:0):o(_,w[S],P?he:Re,P?b:0),n.setCursor=(_,S,P)=>{zt=_.left,Yt=_.top,pr(null,S,P)};function Np(_,S){Wt(Yr,to,Vt.left=_),Wt(Yr,la,Vt.width=S)}function Up(_,S){Wt(Yr,"top",Vt.top=_),Wt(Yr,ca,Vt.height=S)}let Qo=D.ori==0?Np:Up,ea=D.ori==1?Np:Up;function Dx(){if(ee&&de.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&at)continue;let S=de.values[_],P=0;for(let L in S)Fe[_][P++].firstChild.nodeValue=S[L]}}function Uu(_,S){if(_!=null&&(_.idxs?_.idxs.forEach((P,L)=>{ie[L]=P}):Gv(_.idx)||ie.fill(_.idx),de.idx=ie[0]),ee&&de.live){for(let P=0;P<y.length;P++)(P>0||s==1&&!at)&&Nx(P,ie[P]);Dx()}pe=!1,S!==!1&&An("setLegend")}n.setLegend=Uu;function Nx(_,S){let P=y[_],L=_==0&&W==2?ri:e[_],V;at?V=P.values(n,_,S)??st:(V=P.value(n,S==null?null:L[S],_,S),V=V==null?st:{_:V}),de.values[_]=V}function pr(_,S,P){Lp=zt,Dp=Yt,[zt,Yt]=ue.move(n,zt,Yt),ue.left=zt,ue.top=Yt,me&&(Hr&&ts(Hr,vn(zt),0,F,Re),Wr&&ts(Wr,0,vn(Yt),F,Re));let L,V=sn>rn;_s=Ft,zs=null;let J=D.ori==0?F:Re,ae=D.ori==1?F:Re;if(zt<0||jt==0||V){L=ue.idx=null;for(let fe=0;fe<y.length;fe++){let Se=lt[fe];Se!=null&&ts(Se,-10,-10,F,Re)}Je&&Zi(null,$r,!0,_==null&&dn.setSeries),de.live&&(ie.fill(L),pe=!0)}else{let fe,Se,De;s==1&&(fe=D.ori==0?zt:Yt,Se=Ki(fe,E),L=ue.idx=Ui(Se,e[0],sn,rn),De=H(e[0][L],D,J,0));let Ne=-10,Oe=-10,rt=0,wt=0,St=!0,gt="",Ze="";for(let We=s==2?1:0;We<y.length;We++){let Gt=y[We],en=ie[We],Cn=en==null?null:s==1?e[We][en]:e[We][1][en],Nt=ue.dataIdx(n,We,L,Se),tn=Nt==null?null:s==1?e[We][Nt]:e[We][1][Nt];if(pe=pe||tn!=Cn||Nt!=en,ie[We]=Nt,We>0&&Gt.show){let oi=Nt==null?-10:Nt==L?De:H(s==1?e[0][Nt]:e[We][0][Nt],D,J,0),Hn=tn==null?-10:I(tn,s==1?w[Gt.scale]:w[Gt.facets[1].scale],ae,0);if(Je&&tn!=null){let _i=D.ori==1?zt:Yt,Ci=yn(ke.dist(n,We,Nt,Hn,_i));if(Ci<_s){let Ji=ke.bias;if(Ji!=0){let ai=Ki(_i,Gt.scale),xi=tn>=0?1:-1,Ri=ai>=0?1:-1;Ri==xi&&(Ri==1?Ji==1?tn>=ai:tn<=ai:Ji==1?tn<=ai:tn>=ai)&&(_s=Ci,zs=We)}else _s=Ci,zs=We}}if(pe||Ce){let _i,Ci;D.ori==0?(_i=oi,Ci=Hn):(_i=Hn,Ci=oi);let Ji,ai,xi,Ri,ji,Wn,li=!0,mr=ce.bbox;if(mr!=null){li=!1;let Xn=mr(n,We);xi=Xn.left,Ri=Xn.top,Ji=Xn.width,ai=Xn.height}else xi=_i,Ri=Ci,Ji=ai=ce.size(n,We);if(Wn=ce.fill(n,We),ji=ce.stroke(n,We),Ce)We==zs&&_s<=ke.prox&&(Ne=xi,Oe=Ri,rt=Ji,wt=ai,St=li,gt=Wn,Ze=ji);else{let Xn=lt[We];Xn!=null&&(Bt[We]=xi,Vn[We]=Ri,Pm(Xn,Ji,ai,li),Cm(Xn,Wn,ji),ts(Xn,bi(xi),bi(Ri),F,Re))}}}}if(Ce){let We=ke.prox,Gt=fr==null?_s<=We:_s>We||zs!=fr;if(pe||Gt){let en=lt[0];en!=null&&(Bt[0]=Ne,Vn[0]=Oe,Pm(en,rt,wt,St),Cm(en,gt,Ze),ts(en,bi(Ne),bi(Oe),F,Re))}}}if(Vt.show&&ks)if(_!=null){let[fe,Se]=dn.scales,[De,Ne]=dn.match,[Oe,rt]=_.cursor.sync.scales,wt=_.cursor.drag;if(En=wt._x,Tn=wt._y,En||Tn){let{left:St,top:gt,width:Ze,height:We}=_.select,Gt=_.scales[Oe].ori,en=_.posToVal,Cn,Nt,tn,oi,Hn,_i=fe!=null&&De(fe,Oe),Ci=Se!=null&&Ne(Se,rt);_i&&En?(Gt==0?(Cn=St,Nt=Ze):(Cn=gt,Nt=We),tn=w[fe],oi=H(en(Cn,Oe),tn,J,0),Hn=H(en(Cn+Nt,Oe),tn,J,0),Qo(Fi(oi,Hn),yn(Hn-oi))):Qo(0,J),Ci&&Tn?(Gt==1?(Cn=St,Nt=Ze):(Cn=gt,Nt=We),tn=w[Se],oi=I(en(Cn,rt),tn,ae,0),Hn=I(en(Cn+Nt,rt),tn,ae,0),ea(Fi(oi,Hn),yn(Hn-oi))):ea(0,ae)}else ku()}else{let fe=yn(Lp-Pp),Se=yn(Dp-Ip);if(D.ori==1){let rt=fe;fe=Se,Se=rt}En=Dn.x&&fe>=Dn.dist,Tn=Dn.y&&Se>=Dn.dist;let De=Dn.uni;De!=null?En&&Tn&&(En=fe>=De,Tn=Se>=De,!En&&!Tn&&(Se>fe?Tn=!0:En=!0)):Dn.x&&Dn.y&&(En||Tn)&&(En=Tn=!0);let Ne,Oe;En&&(D.ori==0?(Ne=Xr,Oe=zt):(Ne=qr,Oe=Yt),Qo(Fi(Ne,Oe),yn(Oe-Ne)),Tn||ea(0,ae)),Tn&&(D.ori==1?(Ne=Xr,Oe=zt):(Ne=qr,Oe=Yt),ea(Fi(Ne,Oe),yn(Oe-Ne)),En||Qo(0,J)),!En&&!Tn&&(Qo(0,0),ea(0,0))}if(Dn._x=En,Dn._y=Tn,_==null){if(P){if(qp!=null){let[fe,Se]=dn.scales;dn.values[0]=fe!=null?Ki(D.ori==0?zt:Yt,fe):null,dn.values[1]=Se!=null?Ki(D.ori==1?zt:Yt,Se):null}na(nd,n,zt,Yt,F,Re,L)}if(Je){let fe=P&&dn.setSeries,Se=ke.prox;fr==null?_s<=Se&&Zi(zs,$r,!0,fe):_s>Se?Zi(null,$r,!0,fe):zs!=fr&&Zi(zs,$r,!0,fe)}}pe&&(de.idx=L,Uu()),S!==!1&&An("setCursor")}let Vs=null;Object.defineProperty(n,"rect",{get(){return Vs==null&&ta(!1),Vs}});function ta(_=!1){_?Vs=null:(Vs=g.getBoundingClientRect(),An("syncRect",Vs))}function Fp(_,S,P,L,V,J,ae){ue._lock||ks&&_!=null&&_.movementX==0&&_.movementY==0||(Fu(_,S,P,L,V,J,ae,!1,_!=null),_!=null?pr(null,!0,!0):pr(S,!0,!1))}function Fu(_,S,P,L,V,J,ae,fe,Se){if(Vs==null&&ta(!1),Ke(_),_!=null)P=_.clientX-Vs.left,L=_.clientY-Vs.top;else{if(P<0||L<0){zt=-10,Yt=-10;return}let[De,Ne]=dn.scales,Oe=S.cursor.sync,[rt,wt]=Oe.values,[St,gt]=Oe.scales,[Ze,We]=dn.match,Gt=S.axes[0].side%2==1,en=D.ori==0?F:Re,Cn=D.ori==1?F:Re,Nt=Gt?J:V,tn=Gt?V:J,oi=Gt?L:P,Hn=Gt?P:L;if(St!=null?P=Ze(De,St)?a(rt,w[De],en,0):-10:P=en*(oi/Nt),gt!=null?L=We(Ne,gt)?a(wt,w[Ne],Cn,0):-10:L=Cn*(Hn/tn),D.ori==1){let _i=P;P=L,L=_i}}Se&&(S==null||S.cursor.event.type==nd)&&((P<=1||P>=F-1)&&(P=_r(P,F)),(L<=1||L>=Re-1)&&(L=_r(L,Re))),fe?(Pp=P,Ip=L,[Xr,qr]=ue.move(n,P,L)):(zt=P,Yt=L)}let Ou={width:0,height:0,left:0,top:0};function ku(){pl(Ou,!1)}let Op,kp,Bp,zp;function Vp(_,S,P,L,V,J,ae){ks=!0,En=Tn=Dn._x=Dn._y=!1,Fu(_,S,P,L,V,J,ae,!0,!1),_!=null&&(bt(id,ld,Gp,!1),na(bm,n,Xr,qr,F,Re,null));let{left:fe,top:Se,width:De,height:Ne}=Vt;Op=fe,kp=Se,Bp=De,zp=Ne}function Gp(_,S,P,L,V,J,ae){ks=Dn._x=Dn._y=!1,Fu(_,S,P,L,V,J,ae,!1,!0);let{left:fe,top:Se,width:De,height:Ne}=Vt,Oe=De>0||Ne>0,rt=Op!=fe||kp!=Se||Bp!=De||zp!=Ne;if(Oe&&rt&&pl(Vt),Dn.setScale&&Oe&&rt){let wt=fe,St=De,gt=Se,Ze=Ne;if(D.ori==1&&(wt=Se,St=Ne,gt=fe,Ze=De),En&&Bs(E,Ki(wt,E),Ki(wt+St,E)),Tn)for(let We in w){let Gt=w[We];We!=E&&Gt.from==null&&Gt.min!=Ft&&Bs(We,Ki(gt+Ze,We),Ki(gt,We))}ku()}else ue.lock&&(ue._lock=!ue._lock,pr(S,!0,_!=null));_!=null&&(_n(id,ld),na(id,n,zt,Yt,F,Re,null))}function Ux(_,S,P,L,V,J,ae){if(ue._lock)return;Ke(_);let fe=ks;if(ks){let Se=!0,De=!0,Ne=10,Oe,rt;D.ori==0?(Oe=En,rt=Tn):(Oe=Tn,rt=En),Oe&&rt&&(Se=zt<=Ne||zt>=F-Ne,De=Yt<=Ne||Yt>=Re-Ne),Oe&&Se&&(zt=zt<Xr?0:F),rt&&De&&(Yt=Yt<qr?0:Re),pr(null,!0,!0),ks=!1}zt=-10,Yt=-10,ie.fill(null),pr(null,!0,!0),fe&&(ks=fe)}function Hp(_,S,P,L,V,J,ae){ue._lock||(Ke(_),jo(),ku(),_!=null&&na(wm,n,zt,Yt,F,Re,null))}function Wp(){A.forEach(sb),U(n.width,n.height,!0)}yr($l,io,Wp);let Zr={};Zr.mousedown=Vp,Zr.mousemove=Fp,Zr.mouseup=Gp,Zr.dblclick=Hp,Zr.setSeries=(_,S,P,L)=>{let V=dn.match[2];P=V(n,S,P),P!=-1&&Zi(P,L,!0,!1)},me&&(bt(bm,g,Vp),bt(nd,g,Fp),bt(Sm,g,_=>{Ke(_),ta(!1)}),bt(Mm,g,Ux),bt(wm,g,Hp),gd.add(n),n.syncRect=ta);let ml=n.hooks=i.hooks||{};function An(_,S,P){Gn?Lt.push([_,S,P]):_ in ml&&ml[_].forEach(L=>{L.call(null,n,S,P)})}(i.plugins||[]).forEach(_=>{for(let S in _.hooks)ml[S]=(ml[S]||[]).concat(_.hooks[S])});let Xp=(_,S,P)=>P,dn=fn({key:null,setSeries:!1,filters:{pub:Um,sub:Um},scales:[E,y[1]?y[1].scale:null],match:[Fm,Fm,Xp],values:[null,null]},ue.sync);dn.match.length==2&&dn.match.push(Xp),ue.sync=dn;let qp=dn.key,Bu=Lg(qp);function na(_,S,P,L,V,J,ae){dn.filters.pub(_,S,P,L,V,J,ae)&&Bu.pub(_,S,P,L,V,J,ae)}Bu.sub(n);function Fx(_,S,P,L,V,J,ae){dn.filters.sub(_,S,P,L,V,J,ae)&&Zr[_](null,S,P,L,V,J,ae)}n.pub=Fx;function Ox(){Bu.unsub(n),gd.delete(n),wn.clear(),ud($l,io,Wp),c.remove(),xe?.remove(),An("destroy")}n.destroy=Ox;function zu(){An("init",i,e),Jo(e||i.data,!1),O[E]?Lu(E,O[E]):jo(),se=Vt.show&&(Vt.width>0||Vt.height>0),te=pe=!0,U(i.width,i.height)}return y.forEach(Br),A.forEach(fs),t?t instanceof HTMLElement?(t.appendChild(c),zu()):t(n,zu):zu(),n}Nn.assign=fn;Nn.fmtNum=Md;Nn.rangeNum=Zl;Nn.rangeLog=jl;Nn.rangeAsinh=bd;Nn.orient=Sr;Nn.pxRatio=Et;Nn.join=Zv;Nn.fmtDate=Ed,Nn.tzDate=oy;Nn.sync=Lg;{Nn.addGap=Gy,Nn.clipGaps=tc;let i=Nn.paths={points:kg};i.linear=zg,i.stepped=Xy,i.bars=qy,i.spline=$y}function rb(i){if(!(i>0))return 1;let e=10**Math.floor(Math.log10(i));for(let t of[1,2,2.5,5])if(t*e>=i*(1-1e-9))return t*e;return 10*e}function Ld(i,e,t){let n=Math.min(Number.isFinite(i)?i:t[0],t[0]),s=Math.max(Number.isFinite(e)?e:t[1],t[1]),r=rb((s-n)/4),o=r*1e-6;return[Math.floor((n+o)/r)*r,Math.ceil((s-o)/r)*r]}function Wg(i){let e=1/0,t=-1/0;for(let n of i)for(let s of n)s<e&&(e=s),s>t&&(t=s);return[e,t]}var ob=44,ab=20,Xg="11px B612, sans-serif",Ys=class{constructor(e){this.options=e;this.range=Ld(NaN,NaN,e.soft);let t=G("div",{class:"plot-key"});for(let n of e.curves){let s=G("span",{class:"plot-value"});if(this.values.push(s),n.quiet===!0)continue;let r=G("i",{class:n.dash?"swatch dashed":"swatch"});r.style.color=n.colour,t.append(G("span",{class:"plot-curve"},r,n.label,...n.nameOnly===!0?[]:[s]))}this.element=G("section",{class:"plot",id:`plot-${e.id}`,"aria-label":`${e.title}, ${e.unit}`},G("header",{},G("h2",{},e.title,G("span",{class:"plot-unit"},e.unit)),t),this.canvas),this.plot=new Nn(this.uplotOptions(),e.curves.reduce(n=>[...n,[]],[[]]),this.canvas)}options;element;canvas=G("div",{class:"plot-canvas"});values=[];plot;end_s=1;from_s=0;range;resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e>0&&t>0&&(e!==this.plot.width||t!==this.plot.height)&&this.plot.setSize({width:e,height:t})}show(e,t){if(nn(this.element,"stale",e.stale("/estimate")),e.series.length===0)return;this.end_s=e.series.last_s,this.from_s=Math.max(this.end_s-t,0),this.end_s=Math.max(this.end_s,this.from_s+t);let n=e.series.since(this.from_s),s=o=>n[Ju[o]]??new Float64Array,r=this.options.curves.map(o=>s(o.column));this.range=Ld(...Wg(r),this.options.soft),this.plot.setData([s("t_s"),...r]),this.figures()}figures(){let e=this.plot.data,t=this.plot.cursor.idx??(e[0]?.length??0)-1;this.values.forEach((n,s)=>{et(n,dt(e[s+1]?.[t],this.options.decimals))})}uplotOptions(){let e={stroke:"#1b242e",width:1},t=this.options.times===!0;return{width:300,height:100,legend:{show:!1},padding:[6,10,t?0:4,0],cursor:{y:!1,points:{size:5},drag:{x:!1,y:!1},sync:{key:"time",setSeries:!1}},scales:{x:{time:!1,range:()=>[this.from_s,this.end_s]},y:{range:()=>this.range}},axes:[{show:!0,size:t?ab:0,stroke:Zu,font:Xg,grid:e,ticks:{show:!1},gap:4,space:48,values:(n,s)=>t?s.map(r=>dt(r,0)):s.map(()=>"")},{size:ob,stroke:Zu,font:Xg,grid:e,ticks:{show:!1},gap:6,space:22,values:(n,s)=>s.map(r=>dt(r,lb(s)))}],series:[{},...this.options.curves.map(n=>({stroke:n.colour,width:n.width??1.5,...n.dash?{dash:n.dash}:{},points:{show:!1}}))],hooks:{setCursor:[()=>{this.figures()}]}}}};function lb(i){let e=Math.abs((i[1]??1)-(i[0]??0));return Math.max(0,Math.min(3,Math.ceil(-Math.log10(e)-1e-9)+(/[^0]5/.test(e.toPrecision(2))?1:0)))}var{model:qg,odometry:Yg,fused:$g,truth:cb}=vi,hb={colour:Di,dash:[5,4],width:1.2},rc=class{element=G("div",{class:"plots"});window_s=60;plots;truth;truthKnown=!1;constructor(){this.truth=new Ys({id:"truth",title:"Error to truth",unit:"mm",decimals:1,soft:[0,10],curves:[{label:"model",column:"model_error_mm",colour:qg},{label:"odom",column:"odometry_error_mm",colour:Yg},{label:"fused",column:"fused_error_mm",colour:$g}]}),this.truth.element.hidden=!0,this.plots=[new Ys({id:"yaw",title:"Yaw",unit:"°",decimals:1,soft:[-10,10],curves:[{label:"truth",column:"truth_yaw_deg",colour:cb,quiet:!0},{label:"model",column:"model_yaw_deg",colour:qg},{label:"odom",column:"odometry_yaw_deg",colour:Yg},{label:"fused",column:"fused_yaw_deg",colour:$g},{label:"plan",column:"desired_yaw_deg",...hb,nameOnly:!0}]}),new Ys({id:"error",title:"Tracking error",unit:"mm, °",decimals:1,soft:[-4,4],curves:[{label:"cross-track",column:"cross_track_mm",colour:"#d7dee7"},{label:"heading °",column:"heading_error_deg",colour:"#b79cf0"}]}),this.truth,new Ys({id:"speed",title:"Track speed",unit:"m/s",decimals:3,soft:[-.05,.15],curves:[{label:"wanted left",column:"left_commanded_mps",colour:ia,dash:[3,3],width:1,quiet:!0},{label:"wanted right",column:"right_commanded_mps",colour:sa,dash:[3,3],width:1,quiet:!0},{label:"left",column:"left_mps",colour:ia},{label:"right",column:"right_mps",colour:sa}]}),new Ys({id:"slip",title:"Slip",unit:"%",decimals:1,soft:[0,20],times:!0,curves:[{label:"fused left",column:"fused_slip_left_percent",colour:ia,dash:[3,3],width:1,quiet:!0},{label:"fused right",column:"fused_slip_right_percent",colour:sa,dash:[3,3],width:1,quiet:!0},{label:"left",column:"slip_left_percent",colour:ia},{label:"right",column:"slip_right_percent",colour:sa}]})],this.element.append(...this.plots.map(t=>t.element)),new ResizeObserver(()=>{for(let t of this.plots)t.resize()}).observe(this.element)}show(e){!this.truthKnown&&e.get("/estimate")?.truth&&(this.truthKnown=!0,this.truth.element.hidden=!1),nn(this.element,"with-truth",this.truthKnown);for(let t of this.plots)t.element.hidden||(t.resize(),t.show(e,this.window_s))}};var ub=5e3,oc=class{constructor(e,t=()=>performance.now()){this.open=e;this.now=t;let n=["run","recorded","size",""].map(s=>G("th",{scope:"col"},s));this.table=G("table",{},G("thead",{},G("tr",{},...n)),this.body),this.element.append(this.table,this.empty),this.table.hidden=!0}open;now;element=G("div",{class:"runs",tabindex:"0"});body=G("tbody");empty=G("p",{class:"empty"});table;next_ms=0;shown="";show(){this.now()<this.next_ms||(this.next_ms=this.now()+ub,this.load())}changed(){this.next_ms=0}async load(){try{let e=await fetch("/api/runs",{cache:"no-store"});if(!e.ok)throw new Error(e.statusText);let t=await e.text();if(t===this.shown)return;this.shown=t;let{runs:n,directory:s}=JSON.parse(t);this.body.replaceChildren(...n.map(r=>this.row(r))),this.table.hidden=n.length===0,this.empty.hidden=n.length>0,this.empty.textContent=s?`No runs in ${s} yet. Press Record, or start tp100d with --record.`:"Nothing is recorded: start tp100d with --record DIR."}catch{this.shown="",this.empty.hidden=!this.table.hidden,this.empty.textContent="The list of runs is not available now."}}row(e){let t=G("td",{class:"run-files"});for(let n of e.files){if(n.kind==="recording"){let r=G("button",{type:"button",class:"link"},"replay");r.addEventListener("click",()=>{this.open(n,e)}),t.append(r)}let s=G("a",{href:n.url,title:`${n.name}, ${Hs(n.bytes)}`},n.kind==="other"?n.name:n.kind);n.kind==="report"||n.kind==="figure"?s.target="_blank":s.setAttribute("download",""),t.append(s)}return G("tr",e.active?{class:"active"}:{},G("td",{},e.run),G("td",{},e.active?"recording":new Date(1e3*e.modified_unix_s).toLocaleString()),G("td",{class:"figure"},Hs(e.bytes)),t)}};var uo=class{element;value=G("span",{class:"chip-value"});detail=G("span",{class:"chip-detail"});constructor(e,t){this.element=G("div",{class:"chip",id:`chip-${e}`,"data-lamp":"none"},G("span",{class:"chip-label"},t),this.value,this.detail)}show(e,t,n,s=""){yt(this.element,"data-lamp",e),et(this.value,t),et(this.detail,n),yt(this.element,"title",s)}},db={idle:"none",arming:"wait",running:"good",finished:"done",aborted:"bad",driving:"good"},ac=class{element=G("div",{class:"chips"});run=new uo("run","run");link=new uo("link","link");loop=new uo("loop","loop");viewers=new uo("viewers","viewers");constructor(){this.run.element.setAttribute("role","status"),this.element.append(this.run.element,this.link.element,this.loop.element,this.viewers.element)}show(e,t){this.showRun(e),this.showLink(e,t);let n=e.get("/loop");if(!t||n===void 0||e.stale("/loop"))this.loop.show("none","–","");else{let o=n.overruns+n.missed;this.loop.show(o>0?"warn":"good",`${dt(n.rate_hz,0)} Hz`,`p99.9 ${Ht(n.lateness_us.p999)}`,`${Rn(n.overruns)} overruns, ${Rn(n.missed)} missed cycles, paced by the ${n.pacing}`)}let s=e.get("/client"),r=s?.dropped_total??0;this.viewers.show(r>0?"warn":"none",t?dt(s?.clients.length,0):"–",r>0?`${Rn(r)} dropped`:"","Browsers and other clients of this daemon")}showRun(e){let t=e.get("/state");if(t===void 0||e.stale("/state")){this.run.show("none",t?.run??"–","stale");return}let n=["arming","running","driving"].includes(t.run);if(t.motors_on&&!n){this.run.show("bad",t.run,"motors on","The motors are on, though no run is under way");return}let s=typeof t.run_s=="number"?Ii(t.run_s):"",r=t.run==="driving"&&t.driver?t.driver.by:s;this.run.show(db[t.run]??"none",t.run,r,t.why_not_start)}showLink(e,t){let n=e.get("/link");if(!t){this.link.show("bad","no daemon","");return}if(n===void 0||e.stale("/link")){this.link.show("warn","silent","");return}let s=n.lost_hz+n.bad_hz,r=`${n.kind??"unknown"} robot on ${n.port}, firmware ${n.firmware??"unknown"}; ${Rn(n.counters.lost)} samples lost, ${Rn(n.counters.crc_errors)} CRC errors, ${Rn(n.counters.reconnects)} reconnects`;if(n.session!=="ready"){let o=n.quality==="lost"||n.session==="closed"||n.session==="refused";this.link.show(o?"bad":"wait",n.session,n.port,r);return}this.link.show(n.quality==="good"?"good":"warn",`${dt(n.samples_hz,0)} Hz`,s>.05?`${dt(s,1)} bad/s`:`rtt ${Ht(n.round_trip_us)}`,r)}};var fb=3e3,lc=class{element;line=G("span",{class:"stop-line"});constructor(e){this.element=G("button",{class:"stop",id:"stop",type:"button","data-state":"ready"});let t=G("span",{class:"stop-word"},es("stop"),"STOP");this.element.append(t,this.line),this.line.setAttribute("role","status"),this.line.setAttribute("aria-live","assertive"),this.element.setAttribute("aria-keyshortcuts","Space Escape");let n=-1/0;this.element.addEventListener("pointerdown",s=>{n=s.timeStamp,e()}),this.element.addEventListener("click",s=>{(s.detail===0||s.timeStamp-n>fb)&&e()})}show(e){yt(this.element,"data-state",e.kind),et(this.line,pb(e))}};function pb(i){switch(i.kind){case"ready":return"space or esc";case"pending":return"sent…";case"not_acknowledged":return i.waiting?"not acknowledged · no link":"not acknowledged";case"stopped":{let e=i.by===""||i.took_ms!==null?"":` · ${i.by}`;return i.took_ms===null?`stopped${e}`:`robot stopped in ${dt(i.took_ms,i.took_ms<100?1:0)} ms`}}}var cc=class{element=G("section",{class:"timeline","aria-label":"Progress"});name=G("span",{class:"timeline-name"});strip=G("div",{class:"strip"});fill=G("i",{class:"strip-fill"});marks=G("div",{class:"strip-marks"});time=G("output",{class:"timeline-time"});way=G("output",{class:"timeline-way"});courseShown=-1;constructor(){this.strip.append(this.fill,this.marks),this.element.append(this.name,this.strip,this.way,this.time)}show(e){let t=e.received["/course"]??0,n=e.get("/course");t!==this.courseShown&&(this.courseShown=t,this.build(n));let s=e.get("/state"),r=n?.length_m??0,o=s?.run==="idle"?0:e.get("/estimate")?.progress_m??0,l=`scaleX(${(r>0?Math.min(Math.max(o/r,0),1):0).toFixed(4)})`;this.fill.style.transform!==l&&(this.fill.style.transform=l),et(this.way,r>0?`${dt(o,2)} / ${dt(r,2)} m`:"–"),et(this.time,Ii(s?.run_s??0)),nn(this.element,"stale",e.stale("/estimate"))}reset(){this.courseShown=-1}build(e){if(et(this.name,e===void 0||e.name===""?"no course":`course ${e.name}`),this.name.title=e?.description??"",this.marks.replaceChildren(),e===void 0||e.length_m<=0)return;let t=(n,s,r,o)=>{let a=G("i",{class:`mark ${r}`,title:o});a.style.left=`${(100*n/e.length_m).toFixed(2)}%`,a.style.width=`${(100*(s-n)/e.length_m).toFixed(2)}%`,this.marks.append(a)};for(let[n,s]of[["ramp",e.ramps],["block",e.blocks]])for(let r of s){let o=mb(e,r,"top_m"in r?r.top_m+.3:r.depth_m);o&&t(o[0],o[1],n,`${n}, ${dt(1e3*r.height_m,0)} mm high`)}for(let n of e.disturbances)t(n.at_m,n.at_m+.01,"disturbance","somebody pushes the robot")}};function mb(i,e,t){let n=i.path.filter(o=>Math.hypot(o.x_m-e.x_m,o.y_m-e.y_m)<=t/2),s=n[0],r=n.at(-1);return s&&r?[s.s_m,r.s_m]:void 0}var Dd=[1,2,4,.25],gb=.1,hc=class{element=G("section",{class:"transport","aria-label":"Recording"});name=G("span",{class:"transport-name"});play=G("button",{type:"button",id:"play","aria-label":"Play"});slider=G("input",{type:"range",id:"scrub",min:"0",step:"0.01","aria-label":"Position in the recording, seconds"});time=G("output",{class:"transport-time"});speed=G("button",{type:"button","aria-label":"Speed"},"1×");player;shownPlaying;constructor(e){let t=G("button",{type:"button",id:"live",class:"transport-live"},"back to live");this.element.append(this.name,this.play,this.slider,this.time,this.speed,t),this.element.hidden=!0,this.play.addEventListener("click",()=>this.player?.toggle()),this.slider.addEventListener("input",()=>{this.player!==void 0&&(this.player.playing=!1,this.player.show(Number(this.slider.value)))}),this.speed.addEventListener("click",()=>{this.player!==void 0&&(this.player.speed=Dd[(Dd.indexOf(this.player.speed)+1)%Dd.length]??1,et(this.speed,`${this.player.speed}×`))}),t.addEventListener("click",e)}loading(e,t){this.element.hidden=!1,et(this.name,`${e} · loading ${(100*t).toFixed(0)} %`)}open(e,t){this.player=t,this.element.hidden=!1,this.slider.max=t.duration_s.toFixed(2),et(this.speed,"1×"),et(this.name,e)}close(){this.player=void 0,this.element.hidden=!0}step(e){this.player!==void 0&&(this.player.playing=!1,this.player.show(this.player.position_s+e*gb))}show(){let e=this.player;if(e===void 0)return;let t=e.position_s.toFixed(2);this.slider.value!==t&&(this.slider.value=t),et(this.time,`${Ii(e.position_s)} / ${Ii(e.duration_s)}`),e.playing!==this.shownPlaying&&(this.shownPlaying=e.playing,this.play.replaceChildren(es(e.playing?"pause":"play")),yt(this.play,"aria-label",e.playing?"Pause":"Play"))}};var rr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},or={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},E0=0,hf=1,T0=2;var Pr=1,A0=2,Oo=3,ar=0,jn=1,ti=2,Ir=0,ko=1,uf=2,df=3,ff=4,C0=5;var Lr=100,R0=101,P0=102,I0=103,L0=104,D0=200,N0=201,U0=202,F0=203,pf=204,mf=205,O0=206,k0=207,B0=208,z0=209,V0=210,G0=211,H0=212,W0=213,X0=214,Bc=0,zc=1,Vc=2,Ro=3,Gc=4,Hc=5,Wc=6,Xc=7,_h=0,q0=1,Y0=2,as=0,gf=1,_f=2,xf=3,vf=4,yf=5,bf=6,Sf=7;var Mf=300,Dr=301,Bo=302,xh=303,vh=304,qc=1e3,is=1001,Yc=1002,mn=1003,$0=1004;var $a=1005;var Kn=1006,yh=1007;var Ls=1008;var ni=1009,wf=1010,Ef=1011,zo=1012,bh=1013,Hi=1014,Ti=1015,Wi=1016,Sh=1017,Mh=1018,Nr=1020,Tf=35902,Af=35899,Cf=1021,Rf=1022,Xi=1023,As=1026,Ds=1027,wh=1028,Eh=1029,lr=1030,Th=1031;var Ah=1033,Za=33776,Ka=33777,Ja=33778,ja=33779,Ch=35840,Rh=35841,Ph=35842,Ih=35843,Lh=36196,Dh=37492,Nh=37496,Uh=37488,Fh=37489,Qa=37490,Oh=37491,kh=37808,Bh=37809,zh=37810,Vh=37811,Gh=37812,Hh=37813,Wh=37814,Xh=37815,qh=37816,Yh=37817,$h=37818,Zh=37819,Kh=37820,Jh=37821,jh=36492,Qh=36494,eu=36495,tu=36283,nu=36284,el=36285,iu=36286;var Ma=2300,$c=2301,Oc=2302,nf=2303,sf=2400,rf=2401,of=2402;var Z0=3200;var su=0,K0=1,Ns="",$n="srgb",wa="srgb-linear",Ea="linear",Ct="srgb";var kc=7680;var J0=519,j0=512,Q0=513,e_=514,Pf=515,t_=516,n_=517,If=518,Lf=519,i_=35044;var Df="300 es",Mi=2e3,Po=2001;function _b(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function xb(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ta(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function s_(){let i=Ta("canvas");return i.style.display="block",i}var Zg={},Io=null;function Nf(...i){let e="THREE."+i.shift();Io?Io("log",e,...i):console.log(e,...i)}function r_(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function qe(...i){i=r_(i);let e="THREE."+i.shift();if(Io)Io("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function tt(...i){i=r_(i);let e="THREE."+i.shift();if(Io)Io("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function ba(...i){let e=i.join(" ");e in Zg||(Zg[e]=!0,qe(...i))}function o_(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var a_={[Bc]:Bc,[Vc]:Wc,[Gc]:Gc,[Ro]:Hc,[zc]:zc,[Wc]:Vc,[Xc]:Xc,[Hc]:Ro},zi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},kn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Kg=1234567,Ao=Math.PI/180,Lo=180/Math.PI;function Vo(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(kn[i&255]+kn[i>>8&255]+kn[i>>16&255]+kn[i>>24&255]+"-"+kn[e&255]+kn[e>>8&255]+"-"+kn[e>>16&15|64]+kn[e>>24&255]+"-"+kn[t&63|128]+kn[t>>8&255]+"-"+kn[t>>16&255]+kn[t>>24&255]+kn[n&255]+kn[n>>8&255]+kn[n>>16&255]+kn[n>>24&255]).toLowerCase()}function mt(i,e,t){return Math.max(e,Math.min(t,i))}function Uf(i,e){return(i%e+e)%e}function vb(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function yb(i,e,t){return i!==e?(t-i)/(e-i):0}function Sa(i,e,t){return(1-t)*i+t*e}function bb(i,e,t,n){return Sa(i,e,1-Math.exp(-t*n))}function Sb(i,e=1){return e-Math.abs(Uf(i,e*2)-e)}function Mb(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function wb(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function Eb(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Tb(i,e){return i+Math.random()*(e-i)}function Ab(i){return i*(.5-Math.random())}function Cb(i){i!==void 0&&(Kg=i);let e=Kg+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Rb(i){return i*Ao}function Pb(i){return i*Lo}function Ib(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Lb(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Ff(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Db(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),d=r((e-n)/2),u=o((e-n)/2),p=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*d,l*u,a*c);break;case"YZY":i.set(l*u,a*h,l*d,a*c);break;case"ZXZ":i.set(l*d,l*u,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*p,a*c);break;case"YXY":i.set(l*p,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*p,a*h,a*c);break;default:qe("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Of(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function l_(i,e){if(e.constructor===Float32Array)return i;let t=Of(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function c_(i,e){if(e.constructor===Float32Array)return i;let t=Of(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var kf={DEG2RAD:Ao,RAD2DEG:Lo,generateUUID:Vo,clamp:mt,euclideanModulo:Uf,mapLinear:vb,inverseLerp:yb,lerp:Sa,damp:bb,pingpong:Sb,smoothstep:Mb,smootherstep:wb,randInt:Eb,randFloat:Tb,randFloatSpread:Ab,seededRandom:Cb,degToRad:Rb,radToDeg:Pb,isPowerOfTwo:Ib,ceilPowerOfTwo:Lb,floorPowerOfTwo:Ff,setQuaternionFromProperEuler:Db,normalize:c_,denormalize:l_},Hf=class Hf{constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(mt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(mt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};Hf.prototype.isVector2=!0;var je=Hf,Jn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],d=n[s+3],u=r[o+0],p=r[o+1],g=r[o+2],v=r[o+3];if(d!==v||l!==u||c!==p||h!==g){let f=l*u+c*p+h*g+d*v;f<0&&(u=-u,p=-p,g=-g,v=-v,f=-f);let m=1-a;if(f<.9995){let y=Math.acos(f),A=Math.sin(y);m=Math.sin(m*y)/A,a=Math.sin(a*y)/A,l=l*m+u*a,c=c*m+p*a,h=h*m+g*a,d=d*m+v*a}else{l=l*m+u*a,c=c*m+p*a,h=h*m+g*a,d=d*m+v*a;let y=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=y,c*=y,h*=y,d*=y}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],d=r[o],u=r[o+1],p=r[o+2],g=r[o+3];return e[t]=a*g+h*d+l*p-c*u,e[t+1]=l*g+h*u+c*d-a*p,e[t+2]=c*g+h*p+a*u-l*d,e[t+3]=h*g-a*d-l*u-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),d=a(r/2),u=l(n/2),p=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*p*g,this._y=c*p*d-u*h*g,this._z=c*h*g+u*p*d,this._w=c*h*d-u*p*g;break;case"YXZ":this._x=u*h*d+c*p*g,this._y=c*p*d-u*h*g,this._z=c*h*g-u*p*d,this._w=c*h*d+u*p*g;break;case"ZXY":this._x=u*h*d-c*p*g,this._y=c*p*d+u*h*g,this._z=c*h*g+u*p*d,this._w=c*h*d-u*p*g;break;case"ZYX":this._x=u*h*d-c*p*g,this._y=c*p*d+u*h*g,this._z=c*h*g-u*p*d,this._w=c*h*d+u*p*g;break;case"YZX":this._x=u*h*d+c*p*g,this._y=c*p*d+u*h*g,this._z=c*h*g-u*p*d,this._w=c*h*d-u*p*g;break;case"XZY":this._x=u*h*d-c*p*g,this._y=c*p*d-u*h*g,this._z=c*h*g+u*p*d,this._w=c*h*d+u*p*g;break;default:qe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],d=t[10],u=n+a+d;if(u>0){let p=.5/Math.sqrt(u+1);this._w=.25/p,this._x=(h-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(n>a&&n>d){let p=2*Math.sqrt(1+n-a-d);this._w=(h-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>d){let p=2*Math.sqrt(1+a-n-d);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+d-n-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(mt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Wf=class Wf{constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Jg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Jg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),d=2*(r*n-o*t);return this.x=t+l*c+o*d-a*h,this.y=n+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(mt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Nd.copy(this).projectOnVector(e),this.sub(Nd)}reflect(e){return this.sub(Nd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(mt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};Wf.prototype.isVector3=!0;var Y=Wf,Nd=new Y,Jg=new Jn,Xf=class Xf{constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],p=n[5],g=n[8],v=s[0],f=s[3],m=s[6],y=s[1],A=s[4],w=s[7],R=s[2],E=s[5],x=s[8];return r[0]=o*v+a*y+l*R,r[3]=o*f+a*A+l*E,r[6]=o*m+a*w+l*x,r[1]=c*v+h*y+d*R,r[4]=c*f+h*A+d*E,r[7]=c*m+h*w+d*x,r[2]=u*v+p*y+g*R,r[5]=u*f+p*A+g*E,r[8]=u*m+p*w+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=h*o-a*c,u=a*l-h*r,p=c*r-o*l,g=t*d+n*u+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/g;return e[0]=d*v,e[1]=(s*c-h*n)*v,e[2]=(a*n-s*o)*v,e[3]=u*v,e[4]=(h*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=p*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return ba("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ud.makeScale(e,t)),this}rotate(e){return ba("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ud.makeRotation(-e)),this}translate(e,t){return ba("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ud.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}};Xf.prototype.isMatrix3=!0;var nt=Xf,Ud=new nt,jg=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Qg=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Nb(){let i={enabled:!0,workingColorSpace:wa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ct&&(s.r=Ts(s.r),s.g=Ts(s.g),s.b=Ts(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ct&&(s.r=Co(s.r),s.g=Co(s.g),s.b=Co(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ns?Ea:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[wa]:{primaries:e,whitePoint:n,transfer:Ea,toXYZ:jg,fromXYZ:Qg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:$n},outputColorSpaceConfig:{drawingBufferColorSpace:$n}},[$n]:{primaries:e,whitePoint:n,transfer:Ct,toXYZ:jg,fromXYZ:Qg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:$n}}}),i}var vt=Nb();function Ts(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Co(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var fo,Zc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{fo===void 0&&(fo=Ta("canvas")),fo.width=e.width,fo.height=e.height;let s=fo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=fo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ta("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ts(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Ts(t[n]/255)*255):t[n]=Ts(t[n]);return{data:t,width:e.width,height:e.height}}else return qe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Ub=0,Do=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Ub++}),this.uuid=Vo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Fd(s[o].image)):r.push(Fd(s[o]))}else r=Fd(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Fd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Zc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(qe("Texture: Unable to serialize Texture."),{})}var Fb=0,Od=new Y,ei=class i extends zi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=is,s=is,r=Kn,o=Ls,a=Xi,l=ni,c=i.DEFAULT_ANISOTROPY,h=Ns){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Fb++}),this.uuid=Vo(),this.name="",this.source=new Do(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new je(0,0),this.repeat=new je(1,1),this.center=new je(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Od).x}get height(){return this.source.getSize(Od).y}get depth(){return this.source.getSize(Od).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){qe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){qe(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Mf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case qc:e.x=e.x-Math.floor(e.x);break;case is:e.x=e.x<0?0:1;break;case Yc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case qc:e.y=e.y-Math.floor(e.y);break;case is:e.y=e.y<0?0:1;break;case Yc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=Mf;ei.DEFAULT_ANISOTROPY=1;var qf=class qf{constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],d=l[8],u=l[1],p=l[5],g=l[9],v=l[2],f=l[6],m=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-v)<.01&&Math.abs(g-f)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+v)<.1&&Math.abs(g+f)<.1&&Math.abs(c+p+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,w=(p+1)/2,R=(m+1)/2,E=(h+u)/4,x=(d+v)/4,T=(g+f)/4;return A>w&&A>R?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=x/n):w>R?w<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(w),n=E/s,r=T/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=x/r,s=T/r),this.set(n,s,r,t),this}let y=Math.sqrt((f-g)*(f-g)+(d-v)*(d-v)+(u-h)*(u-h));return Math.abs(y)<.001&&(y=1),this.x=(f-g)/y,this.y=(d-v)/y,this.z=(u-h)/y,this.w=Math.acos((c+p+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this.w=mt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this.w=mt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(mt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};qf.prototype.isVector4=!0;var $t=qf,Kc=class extends zi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Kn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new $t(0,0,e,t),this.scissorTest=!1,this.viewport=new $t(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Kn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Do(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},mi=class extends Kc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Aa=class extends ei{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=mn,this.minFilter=mn,this.wrapR=is,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Jc=class extends ei{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=mn,this.minFilter=mn,this.wrapR=is,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var gh=class gh{constructor(e,t,n,s,r,o,a,l,c,h,d,u,p,g,v,f){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,d,u,p,g,v,f)}set(e,t,n,s,r,o,a,l,c,h,d,u,p,g,v,f){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=d,m[14]=u,m[3]=p,m[7]=g,m[11]=v,m[15]=f,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new gh().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/po.setFromMatrixColumn(e,0).length(),r=1/po.setFromMatrixColumn(e,1).length(),o=1/po.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let u=o*h,p=o*d,g=a*h,v=a*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=p+g*c,t[5]=u-v*c,t[9]=-a*l,t[2]=v-u*c,t[6]=g+p*c,t[10]=o*l}else if(e.order==="YXZ"){let u=l*h,p=l*d,g=c*h,v=c*d;t[0]=u+v*a,t[4]=g*a-p,t[8]=o*c,t[1]=o*d,t[5]=o*h,t[9]=-a,t[2]=p*a-g,t[6]=v+u*a,t[10]=o*l}else if(e.order==="ZXY"){let u=l*h,p=l*d,g=c*h,v=c*d;t[0]=u-v*a,t[4]=-o*d,t[8]=g+p*a,t[1]=p+g*a,t[5]=o*h,t[9]=v-u*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let u=o*h,p=o*d,g=a*h,v=a*d;t[0]=l*h,t[4]=g*c-p,t[8]=u*c+v,t[1]=l*d,t[5]=v*c+u,t[9]=p*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let u=o*l,p=o*c,g=a*l,v=a*c;t[0]=l*h,t[4]=v-u*d,t[8]=g*d+p,t[1]=d,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=p*d+g,t[10]=u-v*d}else if(e.order==="XZY"){let u=o*l,p=o*c,g=a*l,v=a*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=u*d+v,t[5]=o*h,t[9]=p*d-g,t[2]=g*d-p,t[6]=a*h,t[10]=v*d+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Ob,e,kb)}lookAt(e,t,n){let s=this.elements;return di.subVectors(e,t),di.lengthSq()===0&&(di.z=1),di.normalize(),$s.crossVectors(n,di),$s.lengthSq()===0&&(Math.abs(n.z)===1?di.x+=1e-4:di.z+=1e-4,di.normalize(),$s.crossVectors(n,di)),$s.normalize(),uc.crossVectors(di,$s),s[0]=$s.x,s[4]=uc.x,s[8]=di.x,s[1]=$s.y,s[5]=uc.y,s[9]=di.y,s[2]=$s.z,s[6]=uc.z,s[10]=di.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],p=n[13],g=n[2],v=n[6],f=n[10],m=n[14],y=n[3],A=n[7],w=n[11],R=n[15],E=s[0],x=s[4],T=s[8],B=s[12],N=s[1],D=s[5],W=s[9],H=s[13],I=s[2],O=s[6],q=s[10],z=s[14],le=s[3],K=s[7],Q=s[11],ie=s[15];return r[0]=o*E+a*N+l*I+c*le,r[4]=o*x+a*D+l*O+c*K,r[8]=o*T+a*W+l*q+c*Q,r[12]=o*B+a*H+l*z+c*ie,r[1]=h*E+d*N+u*I+p*le,r[5]=h*x+d*D+u*O+p*K,r[9]=h*T+d*W+u*q+p*Q,r[13]=h*B+d*H+u*z+p*ie,r[2]=g*E+v*N+f*I+m*le,r[6]=g*x+v*D+f*O+m*K,r[10]=g*T+v*W+f*q+m*Q,r[14]=g*B+v*H+f*z+m*ie,r[3]=y*E+A*N+w*I+R*le,r[7]=y*x+A*D+w*O+R*K,r[11]=y*T+A*W+w*q+R*Q,r[15]=y*B+A*H+w*z+R*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],d=e[6],u=e[10],p=e[14],g=e[3],v=e[7],f=e[11],m=e[15],y=l*p-c*u,A=a*p-c*d,w=a*u-l*d,R=o*p-c*h,E=o*u-l*h,x=o*d-a*h;return t*(v*y-f*A+m*w)-n*(g*y-f*R+m*E)+s*(g*A-v*R+m*x)-r*(g*w-v*E+f*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=e[9],u=e[10],p=e[11],g=e[12],v=e[13],f=e[14],m=e[15],y=t*a-n*o,A=t*l-s*o,w=t*c-r*o,R=n*l-s*a,E=n*c-r*a,x=s*c-r*l,T=h*v-d*g,B=h*f-u*g,N=h*m-p*g,D=d*f-u*v,W=d*m-p*v,H=u*m-p*f,I=y*H-A*W+w*D+R*N-E*B+x*T;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let O=1/I;return e[0]=(a*H-l*W+c*D)*O,e[1]=(s*W-n*H-r*D)*O,e[2]=(v*x-f*E+m*R)*O,e[3]=(u*E-d*x-p*R)*O,e[4]=(l*N-o*H-c*B)*O,e[5]=(t*H-s*N+r*B)*O,e[6]=(f*w-g*x-m*A)*O,e[7]=(h*x-u*w+p*A)*O,e[8]=(o*W-a*N+c*T)*O,e[9]=(n*N-t*W-r*T)*O,e[10]=(g*E-v*w+m*y)*O,e[11]=(d*w-h*E-p*y)*O,e[12]=(a*B-o*D-l*T)*O,e[13]=(t*D-n*B+s*T)*O,e[14]=(v*A-g*R-f*y)*O,e[15]=(h*R-d*A+u*y)*O,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,d=a+a,u=r*c,p=r*h,g=r*d,v=o*h,f=o*d,m=a*d,y=l*c,A=l*h,w=l*d,R=n.x,E=n.y,x=n.z;return s[0]=(1-(v+m))*R,s[1]=(p+w)*R,s[2]=(g-A)*R,s[3]=0,s[4]=(p-w)*E,s[5]=(1-(u+m))*E,s[6]=(f+y)*E,s[7]=0,s[8]=(g+A)*x,s[9]=(f-y)*x,s[10]=(1-(u+v))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=po.set(s[0],s[1],s[2]).length(),a=po.set(s[4],s[5],s[6]).length(),l=po.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Oi.copy(this);let c=1/o,h=1/a,d=1/l;return Oi.elements[0]*=c,Oi.elements[1]*=c,Oi.elements[2]*=c,Oi.elements[4]*=h,Oi.elements[5]*=h,Oi.elements[6]*=h,Oi.elements[8]*=d,Oi.elements[9]*=d,Oi.elements[10]*=d,t.setFromRotationMatrix(Oi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Mi,l=!1){let c=this.elements,h=2*r/(t-e),d=2*r/(n-s),u=(t+e)/(t-e),p=(n+s)/(n-s),g,v;if(l)g=r/(o-r),v=o*r/(o-r);else if(a===Mi)g=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Po)g=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Mi,l=!1){let c=this.elements,h=2/(t-e),d=2/(n-s),u=-(t+e)/(t-e),p=-(n+s)/(n-s),g,v;if(l)g=1/(o-r),v=o/(o-r);else if(a===Mi)g=-2/(o-r),v=-(o+r)/(o-r);else if(a===Po)g=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}};gh.prototype.isMatrix4=!0;var Rt=gh,po=new Y,Oi=new Rt,Ob=new Y(0,0,0),kb=new Y(1,1,1),$s=new Y,uc=new Y,di=new Y,e0=new Rt,t0=new Jn,Cs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(mt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-mt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(mt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-mt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(mt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-mt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,p),this._y=0);break;default:qe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return e0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(e0,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return t0.setFromEuler(this),this.setFromQuaternion(t0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Cs.DEFAULT_ORDER="XYZ";var Ca=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Bb=0,n0=new Y,mo=new Jn,ys=new Rt,dc=new Y,pa=new Y,zb=new Y,Vb=new Jn,i0=new Y(1,0,0),s0=new Y(0,1,0),r0=new Y(0,0,1),o0={type:"added"},Gb={type:"removed"},go={type:"childadded",child:null},kd={type:"childremoved",child:null},Un=class i extends zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Bb++}),this.uuid=Vo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new Y,t=new Cs,n=new Jn,s=new Y(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Rt},normalMatrix:{value:new nt}}),this.matrix=new Rt,this.matrixWorld=new Rt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ca,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return mo.setFromAxisAngle(e,t),this.quaternion.multiply(mo),this}rotateOnWorldAxis(e,t){return mo.setFromAxisAngle(e,t),this.quaternion.premultiply(mo),this}rotateX(e){return this.rotateOnAxis(i0,e)}rotateY(e){return this.rotateOnAxis(s0,e)}rotateZ(e){return this.rotateOnAxis(r0,e)}translateOnAxis(e,t){return n0.copy(e).applyQuaternion(this.quaternion),this.position.add(n0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(i0,e)}translateY(e){return this.translateOnAxis(s0,e)}translateZ(e){return this.translateOnAxis(r0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ys.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?dc.copy(e):dc.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),pa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ys.lookAt(pa,dc,this.up):ys.lookAt(dc,pa,this.up),this.quaternion.setFromRotationMatrix(ys),s&&(ys.extractRotation(s.matrixWorld),mo.setFromRotationMatrix(ys),this.quaternion.premultiply(mo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(o0),go.child=e,this.dispatchEvent(go),go.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Gb),kd.child=e,this.dispatchEvent(kd),kd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ys.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ys.multiply(e.parent.matrixWorld)),e.applyMatrix4(ys),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(o0),go.child=e,this.dispatchEvent(go),go.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(pa,e,zb),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(pa,Vb,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),d=o(e.shapes),u=o(e.skeletons),p=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),p.length>0&&(n.animations=p),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Un.DEFAULT_UP=new Y(0,1,0);Un.DEFAULT_MATRIX_AUTO_UPDATE=!0;Un.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var wi=class extends Un{constructor(){super(),this.isGroup=!0,this.type="Group"}},Hb={type:"move"},No=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new wi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new wi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Y,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Y),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new wi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Y,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Y,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let f=t.getJointPose(v,n),m=this._getHandJoint(c,v);f!==null&&(m.matrix.fromArray(f.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=f.radius),m.visible=f!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),p=.02,g=.005;c.inputState.pinching&&u>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Hb)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new wi;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},h_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Zs={h:0,s:0,l:0},fc={h:0,s:0,l:0};function Bd(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ct=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=$n){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,vt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=vt.workingColorSpace){return this.r=e,this.g=t,this.b=n,vt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=vt.workingColorSpace){if(e=Uf(e,1),t=mt(t,0,1),n=mt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Bd(o,r,e+1/3),this.g=Bd(o,r,e),this.b=Bd(o,r,e-1/3)}return vt.colorSpaceToWorking(this,s),this}setStyle(e,t=$n){function n(r){r!==void 0&&parseFloat(r)<1&&qe("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:qe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);qe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=$n){let n=h_[e.toLowerCase()];return n!==void 0?this.setHex(n,t):qe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ts(e.r),this.g=Ts(e.g),this.b=Ts(e.b),this}copyLinearToSRGB(e){return this.r=Co(e.r),this.g=Co(e.g),this.b=Co(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=$n){return vt.workingToColorSpace(Bn.copy(this),e),Math.round(mt(Bn.r*255,0,255))*65536+Math.round(mt(Bn.g*255,0,255))*256+Math.round(mt(Bn.b*255,0,255))}getHexString(e=$n){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=vt.workingColorSpace){vt.workingToColorSpace(Bn.copy(this),t);let n=Bn.r,s=Bn.g,r=Bn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=vt.workingColorSpace){return vt.workingToColorSpace(Bn.copy(this),t),e.r=Bn.r,e.g=Bn.g,e.b=Bn.b,e}getStyle(e=$n){vt.workingToColorSpace(Bn.copy(this),e);let t=Bn.r,n=Bn.g,s=Bn.b;return e!==$n?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Zs),this.setHSL(Zs.h+e,Zs.s+t,Zs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Zs),e.getHSL(fc);let n=Sa(Zs.h,fc.h,t),s=Sa(Zs.s,fc.s,t),r=Sa(Zs.l,fc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Bn=new ct;ct.NAMES=h_;var Ra=class i{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new ct(e),this.near=t,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},Pa=class extends Un{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Cs,this.environmentIntensity=1,this.environmentRotation=new Cs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ki=new Y,bs=new Y,zd=new Y,Ss=new Y,_o=new Y,xo=new Y,a0=new Y,Vd=new Y,Gd=new Y,Hd=new Y,Wd=new $t,Xd=new $t,qd=new $t,Es=class i{constructor(e=new Y,t=new Y,n=new Y){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),ki.subVectors(e,t),s.cross(ki);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){ki.subVectors(s,t),bs.subVectors(n,t),zd.subVectors(e,t);let o=ki.dot(ki),a=ki.dot(bs),l=ki.dot(zd),c=bs.dot(bs),h=bs.dot(zd),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,p=(c*l-a*h)*u,g=(o*h-a*l)*u;return r.set(1-p-g,g,p)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Ss)===null?!1:Ss.x>=0&&Ss.y>=0&&Ss.x+Ss.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Ss)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ss.x),l.addScaledVector(o,Ss.y),l.addScaledVector(a,Ss.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Wd.setScalar(0),Xd.setScalar(0),qd.setScalar(0),Wd.fromBufferAttribute(e,t),Xd.fromBufferAttribute(e,n),qd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Wd,r.x),o.addScaledVector(Xd,r.y),o.addScaledVector(qd,r.z),o}static isFrontFacing(e,t,n,s){return ki.subVectors(n,t),bs.subVectors(e,t),ki.cross(bs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ki.subVectors(this.c,this.b),bs.subVectors(this.a,this.b),ki.cross(bs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;_o.subVectors(s,n),xo.subVectors(r,n),Vd.subVectors(e,n);let l=_o.dot(Vd),c=xo.dot(Vd);if(l<=0&&c<=0)return t.copy(n);Gd.subVectors(e,s);let h=_o.dot(Gd),d=xo.dot(Gd);if(h>=0&&d<=h)return t.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(_o,o);Hd.subVectors(e,r);let p=_o.dot(Hd),g=xo.dot(Hd);if(g>=0&&p<=g)return t.copy(r);let v=p*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(xo,a);let f=h*g-p*d;if(f<=0&&d-h>=0&&p-g>=0)return a0.subVectors(r,s),a=(d-h)/(d-h+(p-g)),t.copy(s).addScaledVector(a0,a);let m=1/(f+v+u);return o=v*m,a=u*m,t.copy(n).addScaledVector(_o,o).addScaledVector(xo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ss=class{constructor(e=new Y(1/0,1/0,1/0),t=new Y(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Bi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Bi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Bi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Bi):Bi.fromBufferAttribute(r,o),Bi.applyMatrix4(e.matrixWorld),this.expandByPoint(Bi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),pc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),pc.copy(n.boundingBox)),pc.applyMatrix4(e.matrixWorld),this.union(pc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Bi),Bi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ma),mc.subVectors(this.max,ma),vo.subVectors(e.a,ma),yo.subVectors(e.b,ma),bo.subVectors(e.c,ma),Ks.subVectors(yo,vo),Js.subVectors(bo,yo),Mr.subVectors(vo,bo);let t=[0,-Ks.z,Ks.y,0,-Js.z,Js.y,0,-Mr.z,Mr.y,Ks.z,0,-Ks.x,Js.z,0,-Js.x,Mr.z,0,-Mr.x,-Ks.y,Ks.x,0,-Js.y,Js.x,0,-Mr.y,Mr.x,0];return!Yd(t,vo,yo,bo,mc)||(t=[1,0,0,0,1,0,0,0,1],!Yd(t,vo,yo,bo,mc))?!1:(gc.crossVectors(Ks,Js),t=[gc.x,gc.y,gc.z],Yd(t,vo,yo,bo,mc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Bi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Bi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ms[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ms[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ms[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ms[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ms[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ms[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ms[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ms[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ms),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ms=[new Y,new Y,new Y,new Y,new Y,new Y,new Y,new Y],Bi=new Y,pc=new ss,vo=new Y,yo=new Y,bo=new Y,Ks=new Y,Js=new Y,Mr=new Y,ma=new Y,mc=new Y,gc=new Y,wr=new Y;function Yd(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){wr.fromArray(i,r);let a=s.x*Math.abs(wr.x)+s.y*Math.abs(wr.y)+s.z*Math.abs(wr.z),l=e.dot(wr),c=t.dot(wr),h=n.dot(wr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var pn=new Y,_c=new je,Wb=0,In=class extends zi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Wb++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=i_,this.updateRanges=[],this.gpuType=Ti,this.version=0,this._normalizationScale=e!==void 0?Of(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)_c.fromBufferAttribute(this,t),_c.applyMatrix3(e),this.setXY(t,_c.x,_c.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)pn.fromBufferAttribute(this,t),pn.applyMatrix3(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)pn.fromBufferAttribute(this,t),pn.applyMatrix4(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)pn.fromBufferAttribute(this,t),pn.applyNormalMatrix(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)pn.fromBufferAttribute(this,t),pn.transformDirection(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):l_(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):c_(e,this.array)}};var Ia=class extends In{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var La=class extends In{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Ln=class extends In{constructor(e,t,n){super(new Float32Array(e),t,n)}},Xb=new ss,ga=new Y,$d=new Y,Rs=class{constructor(e=new Y,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Xb.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ga.subVectors(e,this.center);let t=ga.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(ga,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):($d.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ga.copy(e.center).add($d)),this.expandByPoint(ga.copy(e.center).sub($d))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},qb=0,Si=new Rt,Zd=new Un,So=new Y,fi=new ss,_a=new ss,Pn=new Y,Fn=class i extends zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:qb++}),this.uuid=Vo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(_b(e)?La:Ia)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new nt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Si.makeRotationFromQuaternion(e),this.applyMatrix4(Si),this}rotateX(e){return Si.makeRotationX(e),this.applyMatrix4(Si),this}rotateY(e){return Si.makeRotationY(e),this.applyMatrix4(Si),this}rotateZ(e){return Si.makeRotationZ(e),this.applyMatrix4(Si),this}translate(e,t,n){return Si.makeTranslation(e,t,n),this.applyMatrix4(Si),this}scale(e,t,n){return Si.makeScale(e,t,n),this.applyMatrix4(Si),this}lookAt(e){return Zd.lookAt(e),Zd.updateMatrix(),this.applyMatrix4(Zd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(So).negate(),this.translate(So.x,So.y,So.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ln(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&qe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ss);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Y(-1/0,-1/0,-1/0),new Y(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];fi.setFromBufferAttribute(r),this.morphTargetsRelative?(Pn.addVectors(this.boundingBox.min,fi.min),this.boundingBox.expandByPoint(Pn),Pn.addVectors(this.boundingBox.max,fi.max),this.boundingBox.expandByPoint(Pn)):(this.boundingBox.expandByPoint(fi.min),this.boundingBox.expandByPoint(fi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Rs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Y,1/0);return}if(e){let n=this.boundingSphere.center;if(fi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];_a.setFromBufferAttribute(a),this.morphTargetsRelative?(Pn.addVectors(fi.min,_a.min),fi.expandByPoint(Pn),Pn.addVectors(fi.max,_a.max),fi.expandByPoint(Pn)):(fi.expandByPoint(_a.min),fi.expandByPoint(_a.max))}fi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Pn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Pn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Pn.fromBufferAttribute(a,c),l&&(So.fromBufferAttribute(e,c),Pn.add(So)),s=Math.max(s,n.distanceToSquared(Pn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new In(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let B=0;B<n.count;B++)a[B]=new Y,l[B]=new Y;let h=new Y,d=new Y,u=new Y,p=new je,g=new je,v=new je,f=new Y,m=new Y;function y(B,N,D){c[B]=c[N]=c[D]=1,h.fromBufferAttribute(n,B),d.fromBufferAttribute(n,N),u.fromBufferAttribute(n,D),p.fromBufferAttribute(r,B),g.fromBufferAttribute(r,N),v.fromBufferAttribute(r,D),d.sub(h),u.sub(h),g.sub(p),v.sub(p);let W=1/(g.x*v.y-v.x*g.y);isFinite(W)&&(f.copy(d).multiplyScalar(v.y).addScaledVector(u,-g.y).multiplyScalar(W),m.copy(u).multiplyScalar(g.x).addScaledVector(d,-v.x).multiplyScalar(W),a[B].add(f),a[N].add(f),a[D].add(f),l[B].add(m),l[N].add(m),l[D].add(m))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let B=0,N=A.length;B<N;++B){let D=A[B],W=D.start,H=D.count;for(let I=W,O=W+H;I<O;I+=3)y(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let w=new Y,R=new Y,E=new Y,x=new Y;function T(B){E.fromBufferAttribute(s,B),x.copy(E);let N=a[B];w.copy(N),w.sub(E.multiplyScalar(E.dot(N))).normalize(),R.crossVectors(x,N);let W=R.dot(l[B])<0?-1:1;o.setXYZW(B,w.x,w.y,w.z,W)}for(let B=0,N=n.count;B<N;++B)c[B]&&T(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new In(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let u=0,p=n.count;u<p;u++)n.setXYZ(u,0,0,0);let s=new Y,r=new Y,o=new Y,a=new Y,l=new Y,c=new Y,h=new Y,d=new Y;if(e)for(let u=0,p=e.count;u<p;u+=3){let g=e.getX(u+0),v=e.getX(u+1),f=e.getX(u+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,f),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,f),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(f,c.x,c.y,c.z)}else for(let u=0,p=t.count;u<p;u+=3)s.fromBufferAttribute(t,u+0),r.fromBufferAttribute(t,u+1),o.fromBufferAttribute(t,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Pn.fromBufferAttribute(e,t),Pn.normalize(),e.setXYZ(t,Pn.x,Pn.y,Pn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),p=0,g=0;for(let v=0,f=l.length;v<f;v++){a.isInterleavedBufferAttribute?p=l[v]*a.data.stride+a.offset:p=l[v]*h;for(let m=0;m<h;m++)u[g++]=c[p++]}return new In(u,h,d)}if(this.index===null)return qe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],p=e(u,n);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let p=c[d];h.push(p.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,p=d.length;u<p;u++)h.push(d[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Kd=new Y,Yb=new Y,$b=new nt,pi=class{constructor(e=new Y(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Kd.subVectors(n,t).cross(Yb.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Kd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||$b.getNormalMatrix(e),s=this.coplanarPoint(Kd).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Zb=0,Ps=class extends zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Zb++}),this.uuid=Vo(),this.name="",this.type="Material",this.blending=ko,this.side=ar,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=pf,this.blendDst=mf,this.blendEquation=Lr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ct(0,0,0),this.blendAlpha=0,this.depthFunc=Ro,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=J0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=kc,this.stencilZFail=kc,this.stencilZPass=kc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){qe(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){qe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ct().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new pi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new je().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new je().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ws=new Y,Jd=new Y,xc=new Y,vc=new Y,Ar=class{constructor(e=new Y,t=new Y(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ws)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ws.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ws.copy(this.origin).addScaledVector(this.direction,t),ws.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Jd.copy(e).add(t).multiplyScalar(.5),xc.copy(t).sub(e).normalize(),vc.copy(this.origin).sub(Jd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(xc),a=vc.dot(this.direction),l=-vc.dot(xc),c=vc.lengthSq(),h=Math.abs(1-o*o),d,u,p,g;if(h>0)if(d=o*l-a,u=o*a-l,g=r*h,d>=0)if(u>=-g)if(u<=g){let v=1/h;d*=v,u*=v,p=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),p=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),p=-d*d+u*(u+2*l)+c;else u<=-g?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),p=-d*d+u*(u+2*l)+c):u<=g?(d=0,u=Math.min(Math.max(-r,-l),r),p=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),p=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),p=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Jd).addScaledVector(xc,u),p}intersectSphere(e,t){if(e.radius<0)return null;ws.subVectors(e.center,this.origin);let n=ws.dot(this.direction),s=ws.dot(ws)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(e.min.x-u.x)*c,s=(e.max.x-u.x)*c):(n=(e.max.x-u.x)*c,s=(e.min.x-u.x)*c),h>=0?(r=(e.min.y-u.y)*h,o=(e.max.y-u.y)*h):(r=(e.max.y-u.y)*h,o=(e.min.y-u.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-u.z)*d,l=(e.max.z-u.z)*d):(a=(e.max.z-u.z)*d,l=(e.min.z-u.z)*d),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,ws)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=e.x-o.x,u=e.y-o.y,p=e.z-o.z,g=t.x-o.x,v=t.y-o.y,f=t.z-o.z,m=n.x-o.x,y=n.y-o.y,A=n.z-o.z,w=Math.abs(l),R=Math.abs(c),E=Math.abs(h),x,T,B,N,D,W,H,I,O,q,z,le;if(w>=R&&w>=E?(B=l,W=d,O=g,le=m,l>=0?(x=c,T=h,N=u,D=p,H=v,I=f,q=y,z=A):(x=h,T=c,N=p,D=u,H=f,I=v,q=A,z=y)):R>=E?(B=c,W=u,O=v,le=y,c>=0?(x=h,T=l,N=p,D=d,H=f,I=g,q=A,z=m):(x=l,T=h,N=d,D=p,H=g,I=f,q=m,z=A)):(B=h,W=p,O=f,le=A,h>=0?(x=l,T=c,N=d,D=u,H=g,I=v,q=m,z=y):(x=c,T=l,N=u,D=d,H=v,I=g,q=y,z=m)),B===0)return null;let K=x/B,Q=T/B,ie=1/B,de=N-K*W,ue=D-Q*W,ee=H-K*O,me=I-Q*O,ge=q-K*le,xe=z-Q*le,_e=ge*me-xe*ee,Ve=de*xe-ue*ge,$e=ee*ue-me*de;if(s){if(_e<0||Ve<0||$e<0)return null}else if((_e<0||Ve<0||$e<0)&&(_e>0||Ve>0||$e>0))return null;let Fe=_e+Ve+$e;if(Fe===0)return null;let it=ie*(_e*W+Ve*O+$e*le);return(Fe>0?it<0:it>0)?null:this.at(it/Fe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Qs=class extends Ps{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Cs,this.combine=_h,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},l0=new Rt,Er=new Ar,yc=new Rs,c0=new Y,bc=new Y,Sc=new Y,Mc=new Y,jd=new Y,wc=new Y,h0=new Y,Ec=new Y,Kt=class extends Un{constructor(e=new Fn,t=new Qs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){wc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&(jd.fromBufferAttribute(d,e),o?wc.addScaledVector(jd,h):wc.addScaledVector(jd.sub(t),h))}t.add(wc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),yc.copy(n.boundingSphere),yc.applyMatrix4(r),Er.copy(e.ray).recast(e.near),!(yc.containsPoint(Er.origin)===!1&&(Er.intersectSphere(yc,c0)===null||Er.origin.distanceToSquared(c0)>(e.far-e.near)**2))&&(l0.copy(r).invert(),Er.copy(e.ray).applyMatrix4(l0),!(n.boundingBox!==null&&Er.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Er)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=u.length;g<v;g++){let f=u[g],m=o[f.materialIndex],y=Math.max(f.start,p.start),A=Math.min(a.count,Math.min(f.start+f.count,p.start+p.count));for(let w=y,R=A;w<R;w+=3){let E=a.getX(w),x=a.getX(w+1),T=a.getX(w+2);s=Tc(this,m,e,n,c,h,d,E,x,T),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=f.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),v=Math.min(a.count,p.start+p.count);for(let f=g,m=v;f<m;f+=3){let y=a.getX(f),A=a.getX(f+1),w=a.getX(f+2);s=Tc(this,o,e,n,c,h,d,y,A,w),s&&(s.faceIndex=Math.floor(f/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=u.length;g<v;g++){let f=u[g],m=o[f.materialIndex],y=Math.max(f.start,p.start),A=Math.min(l.count,Math.min(f.start+f.count,p.start+p.count));for(let w=y,R=A;w<R;w+=3){let E=w,x=w+1,T=w+2;s=Tc(this,m,e,n,c,h,d,E,x,T),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=f.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),v=Math.min(l.count,p.start+p.count);for(let f=g,m=v;f<m;f+=3){let y=f,A=f+1,w=f+2;s=Tc(this,o,e,n,c,h,d,y,A,w),s&&(s.faceIndex=Math.floor(f/3),t.push(s))}}}};function Kb(i,e,t,n,s,r,o,a){let l;if(e.side===jn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===ar,a),l===null)return null;Ec.copy(a),Ec.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Ec);return c<t.near||c>t.far?null:{distance:c,point:Ec.clone(),object:i}}function Tc(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,bc),i.getVertexPosition(l,Sc),i.getVertexPosition(c,Mc);let h=Kb(i,e,t,n,bc,Sc,Mc,h0);if(h){let d=new Y;Es.getBarycoord(h0,bc,Sc,Mc,d),s&&(h.uv=Es.getInterpolatedAttribute(s,a,l,c,d,new je)),r&&(h.uv1=Es.getInterpolatedAttribute(r,a,l,c,d,new je)),o&&(h.normal=Es.getInterpolatedAttribute(o,a,l,c,d,new Y),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new Y,materialIndex:0};Es.getNormal(bc,Sc,Mc,u.normal),h.face=u,h.barycoord=d}return h}var Cr=class extends ei{constructor(e=null,t=1,n=1,s,r,o,a,l,c=mn,h=mn,d,u){super(null,o,a,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Da=class extends In{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Mo=new Rt,u0=new Rt,Ac=[],d0=new ss,Jb=new Rt,xa=new Kt,va=new Rs,Na=class extends Kt{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Da(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Jb)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new ss),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Mo),d0.copy(e.boundingBox).applyMatrix4(Mo),this.boundingBox.union(d0)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Rs),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Mo),va.copy(e.boundingSphere).applyMatrix4(Mo),this.boundingSphere.union(va)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(xa.geometry=this.geometry,xa.material=this.material,xa.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),va.copy(this.boundingSphere),va.applyMatrix4(n),e.ray.intersectsSphere(va)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Mo),u0.multiplyMatrices(n,Mo),xa.matrixWorld=u0,xa.raycast(e,Ac);for(let o=0,a=Ac.length;o<a;o++){let l=Ac[o];l.instanceId=r,l.object=this,t.push(l)}Ac.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Da(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new Cr(new Float32Array(s*this.count),s,this.count,wh,Ti));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Tr=new Rs,jb=new je(.5,.5),Cc=new Y,er=class{constructor(e=new pi,t=new pi,n=new pi,s=new pi,r=new pi,o=new pi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Mi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],p=r[7],g=r[8],v=r[9],f=r[10],m=r[11],y=r[12],A=r[13],w=r[14],R=r[15];if(s[0].setComponents(c-o,p-h,m-g,R-y).normalize(),s[1].setComponents(c+o,p+h,m+g,R+y).normalize(),s[2].setComponents(c+a,p+d,m+v,R+A).normalize(),s[3].setComponents(c-a,p-d,m-v,R-A).normalize(),n)s[4].setComponents(l,u,f,w).normalize(),s[5].setComponents(c-l,p-u,m-f,R-w).normalize();else if(s[4].setComponents(c-l,p-u,m-f,R-w).normalize(),t===Mi)s[5].setComponents(c+l,p+u,m+f,R+w).normalize();else if(t===Po)s[5].setComponents(l,u,f,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Tr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Tr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Tr)}intersectsSprite(e){Tr.center.set(0,0,0);let t=jb.distanceTo(e.center);return Tr.radius=.7071067811865476+t,Tr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Tr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Cc.x=s.normal.x>0?e.max.x:e.min.x,Cc.y=s.normal.y>0?e.max.y:e.min.y,Cc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Cc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},f0=new Rt,jc=class i{constructor(){this.coordinateSystem=Mi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];f0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new er),n[s].setFromProjectionMatrix(f0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new er),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Ei=class extends Ps{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ct(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Qc=new Y,eh=new Y,p0=new Rt,ya=new Ar,Rc=new Rs,Qd=new Y,m0=new Y,Ua=class extends Un{constructor(e=new Fn,t=new Ei){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Qc.fromBufferAttribute(t,s-1),eh.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Qc.distanceTo(eh);e.setAttribute("lineDistance",new Ln(n,1))}else qe("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Rc.copy(n.boundingSphere),Rc.applyMatrix4(s),Rc.radius+=r,e.ray.intersectsSphere(Rc)===!1)return;p0.copy(s).invert(),ya.copy(e.ray).applyMatrix4(p0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let p=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let v=p,f=g-1;v<f;v+=c){let m=h.getX(v),y=h.getX(v+1),A=Pc(this,e,ya,l,m,y,v);A&&t.push(A)}if(this.isLineLoop){let v=h.getX(g-1),f=h.getX(p),m=Pc(this,e,ya,l,v,f,g-1);m&&t.push(m)}}else{let p=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=p,f=g-1;v<f;v+=c){let m=Pc(this,e,ya,l,v,v+1,v);m&&t.push(m)}if(this.isLineLoop){let v=Pc(this,e,ya,l,g-1,p,g-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Pc(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Qc.fromBufferAttribute(a,s),eh.fromBufferAttribute(a,r),t.distanceSqToSegment(Qc,eh,Qd,m0)>n)return;Qd.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Qd);if(!(c<e.near||c>e.far))return{distance:c,point:m0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var g0=new Y,_0=new Y,Vi=class extends Ua{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)g0.fromBufferAttribute(t,s),_0.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+g0.distanceTo(_0);e.setAttribute("lineDistance",new Ln(n,1))}else qe("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Fa=class extends Ua{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var Oa=class extends ei{constructor(e=[],t=Dr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Is=class extends ei{constructor(e,t,n=Hi,s,r,o,a=mn,l=mn,c,h=As,d=1){if(h!==As&&h!==Ds)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:d};super(u,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Do(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ka=class extends Is{constructor(e,t=Hi,n=Dr,s,r,o=mn,a=mn,l,c=As){let h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ba=class extends ei{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},tr=class i extends Fn{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,p=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Ln(c,3)),this.setAttribute("normal",new Ln(h,3)),this.setAttribute("uv",new Ln(d,2));function g(v,f,m,y,A,w,R,E,x,T,B){let N=w/x,D=R/T,W=w/2,H=R/2,I=E/2,O=x+1,q=T+1,z=0,le=0,K=new Y;for(let Q=0;Q<q;Q++){let ie=Q*D-H;for(let de=0;de<O;de++){let ue=de*N-W;K[v]=ue*y,K[f]=ie*A,K[m]=I,c.push(K.x,K.y,K.z),K[v]=0,K[f]=0,K[m]=E>0?1:-1,h.push(K.x,K.y,K.z),d.push(de/x),d.push(1-Q/T),z+=1}}for(let Q=0;Q<T;Q++)for(let ie=0;ie<x;ie++){let de=u+ie+O*Q,ue=u+ie+O*(Q+1),ee=u+(ie+1)+O*(Q+1),me=u+(ie+1)+O*Q;l.push(de,ue,me),l.push(ue,ee,me),le+=6}a.addGroup(p,le,B),p+=le,u+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Ic=new Y,Lc=new Y,ef=new Y,Dc=new Es,Rr=class extends Fn{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Ao*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],d=new Array(3),u=new Map,p=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:v,b:f,c:m}=Dc;if(v.fromBufferAttribute(a,c[0]),f.fromBufferAttribute(a,c[1]),m.fromBufferAttribute(a,c[2]),Dc.getNormal(ef),d[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,d[1]=`${Math.round(f.x*s)},${Math.round(f.y*s)},${Math.round(f.z*s)}`,d[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(d[0]===d[1]||d[1]===d[2]||d[2]===d[0]))for(let y=0;y<3;y++){let A=(y+1)%3,w=d[y],R=d[A],E=Dc[h[y]],x=Dc[h[A]],T=`${w}_${R}`,B=`${R}_${w}`,N=u.get(B);N?(ef.dot(N.normal)<=r&&(p.push(E.x,E.y,E.z),p.push(x.x,x.y,x.z)),u.set(B,null)):u.has(T)||u.set(T,{index0:c[y],index1:c[A],normal:ef.clone()})}}for(let g of u.values())if(g){let{index0:v,index1:f}=g;Ic.fromBufferAttribute(a,v),Lc.fromBufferAttribute(a,f),p.push(Ic.x,Ic.y,Ic.z),p.push(Lc.x,Lc.y,Lc.z)}this.setAttribute("position",new Ln(p,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var rs=class i extends Fn{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,d=e/a,u=t/l,p=[],g=[],v=[],f=[];for(let m=0;m<h;m++){let y=m*u-o;for(let A=0;A<c;A++){let w=A*d-r;g.push(w,-y,0),v.push(0,0,1),f.push(A/a),f.push(1-m/l)}}for(let m=0;m<l;m++)for(let y=0;y<a;y++){let A=y+c*m,w=y+c*(m+1),R=y+1+c*(m+1),E=y+1+c*m;p.push(A,w,E),p.push(w,R,E)}this.setIndex(p),this.setAttribute("position",new Ln(g,3)),this.setAttribute("normal",new Ln(v,3)),this.setAttribute("uv",new Ln(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}},za=class i extends Fn{constructor(e=.5,t=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],d=e,u=(t-e)/s,p=new Y,g=new je;for(let v=0;v<=s;v++){for(let f=0;f<=n;f++){let m=r+f/n*o;p.x=d*Math.cos(m),p.y=d*Math.sin(m),l.push(p.x,p.y,p.z),c.push(0,0,1),g.x=(p.x/t+1)/2,g.y=(p.y/t+1)/2,h.push(g.x,g.y)}d+=u}for(let v=0;v<s;v++){let f=v*(n+1);for(let m=0;m<n;m++){let y=m+f,A=y,w=y+n+1,R=y+n+2,E=y+1;a.push(A,w,E),a.push(w,R,E)}}this.setIndex(a),this.setAttribute("position",new Ln(l,3)),this.setAttribute("normal",new Ln(c,3)),this.setAttribute("uv",new Ln(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}};function Ur(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(x0(s))s.isRenderTargetTexture?(qe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(x0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function zn(i){let e={};for(let t=0;t<i.length;t++){let n=Ur(i[t]);for(let s in n)e[s]=n[s]}return e}function x0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Qb(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Bf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:vt.workingColorSpace}var u_={clone:Ur,merge:zn},eS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,tS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,os=class extends Ps{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=eS,this.fragmentShader=tS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ur(e.uniforms),this.uniformsGroups=Qb(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new ct().setHex(s.value);break;case"v2":this.uniforms[n].value=new je().fromArray(s.value);break;case"v3":this.uniforms[n].value=new Y().fromArray(s.value);break;case"v4":this.uniforms[n].value=new $t().fromArray(s.value);break;case"m3":this.uniforms[n].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Rt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},th=class extends os{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Gi=class extends Ps{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ct(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=su,this.normalScale=new je(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Cs,this.combine=_h,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},nh=class extends Ps{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Z0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},ih=class extends Ps{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function wo(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Nc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var nr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},sh=class extends nr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:sf,endingEnd:sf}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case rf:r=e,a=2*t-n;break;case of:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case rf:o=e,l=2*n-t;break;case of:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,p=this._weightNext,g=(n-t)/(s-t),v=g*g,f=v*g,m=-u*f+2*u*v-u*g,y=(1+u)*f+(-1.5-2*u)*v+(-.5+u)*g+1,A=(-1-p)*f+(1.5+p)*v+.5*g,w=p*f-p*v;for(let R=0;R!==a;++R)r[R]=m*o[h+R]+y*o[c+R]+A*o[l+R]+w*o[d+R];return r}},rh=class extends nr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),d=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*h;return r}},oh=class extends nr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},ah=class extends nr{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let g=(n-t)/(s-t),v=1-g;for(let f=0;f!==a;++f)r[f]=o[c+f]*v+o[l+f]*g;return r}let u=a*2,p=e-1;for(let g=0;g!==a;++g){let v=o[c+g],f=o[l+g],m=p*u+g*2,y=d[m],A=d[m+1],w=e*u+g*2,R=h[w],E=h[w+1],x=iS(n,t,y,R,s);r[g]=d_(x,v,A,E,f)}return r}};function d_(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function nS(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function iS(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=d_(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=nS(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var gi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=wo(t,this.TimeBufferType),this.values=wo(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:wo(e.times,Array),values:wo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Nc(e.settings)&&(n.settings={inTangents:wo(e.settings.inTangents,Array),outTangents:wo(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new oh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new rh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new sh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new ah(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ma:t=this.InterpolantFactoryMethodDiscrete;break;case $c:t=this.InterpolantFactoryMethodLinear;break;case Oc:t=this.InterpolantFactoryMethodSmooth;break;case nf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return qe("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ma;case this.InterpolantFactoryMethodLinear:return $c;case this.InterpolantFactoryMethodSmooth:return Oc;case this.InterpolantFactoryMethodBezier:return nf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Nc(this.settings)&&(v0(this.settings.inTangents,e),v0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Nc(this.settings)&&(y0(this.settings.inTangents,e),y0(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&xb(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Oc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let d=a*n,u=d-n,p=d+n;for(let g=0;g!==n;++g){let v=t[d+g];if(v!==t[u+g]||v!==t[p+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*n,u=o*n;for(let p=0;p!==n;++p)t[u+p]=t[d+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Nc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function v0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function y0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}gi.prototype.ValueTypeName="";gi.prototype.TimeBufferType=Float32Array;gi.prototype.ValueBufferType=Float32Array;gi.prototype.DefaultInterpolation=$c;var ir=class extends gi{constructor(e,t,n){super(e,t,n)}};ir.prototype.ValueTypeName="bool";ir.prototype.ValueBufferType=Array;ir.prototype.DefaultInterpolation=Ma;ir.prototype.InterpolantFactoryMethodLinear=void 0;ir.prototype.InterpolantFactoryMethodSmooth=void 0;var lh=class extends gi{constructor(e,t,n,s){super(e,t,n,s)}};lh.prototype.ValueTypeName="color";var ch=class extends gi{constructor(e,t,n,s){super(e,t,n,s)}};ch.prototype.ValueTypeName="number";var hh=class extends nr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Jn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Va=class extends gi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new hh(this.times,this.values,this.getValueSize(),e)}};Va.prototype.ValueTypeName="quaternion";Va.prototype.InterpolantFactoryMethodSmooth=void 0;var sr=class extends gi{constructor(e,t,n){super(e,t,n)}};sr.prototype.ValueTypeName="string";sr.prototype.ValueBufferType=Array;sr.prototype.DefaultInterpolation=Ma;sr.prototype.InterpolantFactoryMethodLinear=void 0;sr.prototype.InterpolantFactoryMethodSmooth=void 0;var uh=class extends gi{constructor(e,t,n,s){super(e,t,n,s)}};uh.prototype.ValueTypeName="vector";var dh=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let p=c[d],g=c[d+1];if(p.global&&(p.lastIndex=0),p.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},f_=new dh,fh=class{constructor(e){this.manager=e!==void 0?e:f_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};fh.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ga=class extends Un{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ct(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Ha=class extends Ga{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Un.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ct(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},tf=new Rt,b0=new Y,S0=new Y,ph=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new je(512,512),this.mapType=ni,this.map=null,this.mapPass=null,this.matrix=new Rt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new er,this._frameExtents=new je(1,1),this._viewportCount=1,this._viewports=[new $t(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;b0.setFromMatrixPosition(e.matrixWorld),t.position.copy(b0),S0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(S0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){tf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(tf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Po||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(tf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Uc=new Y,Fc=new Jn,ns=new Y,Wa=class extends Un{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Rt,this.projectionMatrix=new Rt,this.projectionMatrixInverse=new Rt,this.coordinateSystem=Mi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Uc,Fc,ns),ns.x===1&&ns.y===1&&ns.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Uc,Fc,ns.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Uc,Fc,ns),ns.x===1&&ns.y===1&&ns.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Uc,Fc,ns.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},js=new Y,M0=new je,w0=new je,Zn=class extends Wa{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Lo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ao*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Lo*2*Math.atan(Math.tan(Ao*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){js.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(js.x,js.y).multiplyScalar(-e/js.z),js.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(js.x,js.y).multiplyScalar(-e/js.z)}getViewSize(e,t){return this.getViewBounds(e,M0,w0),t.subVectors(w0,M0)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ao*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Xa=class extends Wa{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},af=class extends ph{constructor(){super(new Xa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},qa=class extends Ga{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Un.DEFAULT_UP),this.updateMatrix(),this.target=new Un,this.shadow=new af}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Eo=-90,To=1,Uo=class extends Un{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Zn(Eo,To,e,t);s.layers=this.layers,this.add(s);let r=new Zn(Eo,To,e,t);r.layers=this.layers,this.add(r);let o=new Zn(Eo,To,e,t);o.layers=this.layers,this.add(o);let a=new Zn(Eo,To,e,t);a.layers=this.layers,this.add(a);let l=new Zn(Eo,To,e,t);l.layers=this.layers,this.add(l);let c=new Zn(Eo,To,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Mi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Po)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=e.getRenderTarget(),u=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let f=!1;e.isWebGLRenderer===!0?f=e.state.buffers.depth.getReversed():f=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=v,e.setRenderTarget(n,5,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,u,p),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},mh=class extends Zn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var zf="\\[\\]\\.:\\/",sS=new RegExp("["+zf+"]","g"),Vf="[^"+zf+"]",rS="[^"+zf.replace("\\.","")+"]",oS=/((?:WC+[\/:])*)/.source.replace("WC",Vf),aS=/(WCOD+)?/.source.replace("WCOD",rS),lS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Vf),cS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Vf),hS=new RegExp("^"+oS+aS+lS+cS+"$"),uS=["material","materials","bones","map"],lf=class{constructor(e,t,n){let s=n||Xt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Xt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(sS,"")}static parseTrackName(e){let t=hS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);uS.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){qe("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Xt.Composite=lf;Xt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Xt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Xt.prototype.GetterByBindingType=[Xt.prototype._getValue_direct,Xt.prototype._getValue_array,Xt.prototype._getValue_arrayElement,Xt.prototype._getValue_toArray];Xt.prototype.SetterByBindingTypeAndVersioning=[[Xt.prototype._setValue_direct,Xt.prototype._setValue_direct_setNeedsUpdate,Xt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_array,Xt.prototype._setValue_array_setNeedsUpdate,Xt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_arrayElement,Xt.prototype._setValue_arrayElement_setNeedsUpdate,Xt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_fromArray,Xt.prototype._setValue_fromArray_setNeedsUpdate,Xt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var JC=new Float32Array(1);var Fo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=mt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(mt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Yf=class Yf{constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};Yf.prototype.isMatrix2=!0;var cf=Yf;var Ya=class extends zi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Gf(i,e,t,n){let s=dS(n);switch(t){case Cf:return i*e;case wh:return i*e/s.components*s.byteLength;case Eh:return i*e/s.components*s.byteLength;case lr:return i*e*2/s.components*s.byteLength;case Th:return i*e*2/s.components*s.byteLength;case Rf:return i*e*3/s.components*s.byteLength;case Xi:return i*e*4/s.components*s.byteLength;case Ah:return i*e*4/s.components*s.byteLength;case Za:case Ka:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Ja:case ja:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Rh:case Ih:return Math.max(i,16)*Math.max(e,8)/4;case Ch:case Ph:return Math.max(i,8)*Math.max(e,8)/2;case Lh:case Dh:case Uh:case Fh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Nh:case Qa:case Oh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case kh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Bh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case zh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Vh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Gh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Hh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Wh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Xh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case qh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Yh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case $h:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Zh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Kh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Jh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case jh:case Qh:case eu:return Math.ceil(i/4)*Math.ceil(e/4)*16;case tu:case nu:return Math.ceil(i/4)*Math.ceil(e/4)*8;case el:case iu:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function dS(i){switch(i){case ni:case wf:return{byteLength:1,components:1};case zo:case Ef:case Wi:return{byteLength:2,components:1};case Sh:case Mh:return{byteLength:2,components:4};case Hi:case bh:case Ti:return{byteLength:4,components:1};case Tf:case Af:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function U_(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function pS(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,l,c){let h=l.array,d=l.updateRanges;if(i.bindBuffer(c,a),d.length===0)i.bufferSubData(c,0,h);else{d.sort((p,g)=>p.start-g.start);let u=0;for(let p=1;p<d.length;p++){let g=d[u],v=d[p];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++u,d[u]=v)}d.length=u+1;for(let p=0,g=d.length;p<g;p++){let v=d[p];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var mS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,gS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,_S=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,xS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,vS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,yS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,bS=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,SS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,MS=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,wS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ES=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,TS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,AS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,CS=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,RS=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,PS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,IS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,LS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,DS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,NS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,US=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,FS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,OS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,kS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,BS=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,zS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,VS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,GS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,HS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,WS="gl_FragColor = linearToOutputTexel( gl_FragColor );",XS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,qS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,YS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,$S=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,ZS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,KS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,JS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,jS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,QS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,eM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,tM=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,nM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,iM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,sM=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,rM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,oM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,aM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,lM=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,cM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,hM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,uM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,dM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,fM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,pM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,mM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,gM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,_M=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,xM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,yM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,bM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,SM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,MM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,wM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,EM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,TM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,AM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,CM=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,RM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,PM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,IM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,LM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,DM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,NM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,UM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,FM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,OM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,kM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,BM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,zM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,VM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,GM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,HM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,WM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,XM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,qM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,YM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,$M=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,ZM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,KM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,JM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,jM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,QM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,ew=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,tw=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,nw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,iw=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,sw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,rw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ow=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,aw=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,lw=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,cw=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,hw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,uw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,dw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,fw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,pw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,mw=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,gw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,_w=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,xw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,bw=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Sw=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Mw=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,ww=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ew=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Tw=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Aw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Cw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Rw=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Pw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Iw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Lw=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Dw=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Nw=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Uw=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Fw=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Ow=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kw=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Bw=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,zw=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Vw=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Gw=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Hw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ww=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Xw=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,qw=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Yw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ut={alphahash_fragment:mS,alphahash_pars_fragment:gS,alphamap_fragment:_S,alphamap_pars_fragment:xS,alphatest_fragment:vS,alphatest_pars_fragment:yS,aomap_fragment:bS,aomap_pars_fragment:SS,batching_pars_vertex:MS,batching_vertex:wS,begin_vertex:ES,beginnormal_vertex:TS,bsdfs:AS,iridescence_fragment:CS,bumpmap_pars_fragment:RS,clipping_planes_fragment:PS,clipping_planes_pars_fragment:IS,clipping_planes_pars_vertex:LS,clipping_planes_vertex:DS,color_fragment:NS,color_pars_fragment:US,color_pars_vertex:FS,color_vertex:OS,common:kS,defaultnormal_vertex:BS,displacementmap_pars_vertex:zS,displacementmap_vertex:VS,emissivemap_fragment:GS,emissivemap_pars_fragment:HS,colorspace_fragment:WS,colorspace_pars_fragment:XS,envmap_fragment:qS,envmap_common_pars_fragment:YS,envmap_pars_fragment:$S,envmap_pars_vertex:ZS,envmap_physical_pars_fragment:oM,envmap_vertex:KS,fog_vertex:JS,fog_pars_vertex:jS,fog_fragment:QS,fog_pars_fragment:eM,gradientmap_pars_fragment:tM,lightmap_pars_fragment:nM,lights_lambert_fragment:iM,lights_lambert_pars_fragment:sM,lights_pars_begin:rM,lights_toon_fragment:aM,lights_toon_pars_fragment:lM,lights_phong_fragment:cM,lights_phong_pars_fragment:hM,lights_physical_fragment:uM,lights_physical_pars_fragment:dM,lights_fragment_begin:fM,lights_fragment_maps:pM,lights_fragment_end:mM,lightprobes_pars_fragment:gM,logdepthbuf_fragment:_M,logdepthbuf_pars_fragment:xM,logdepthbuf_pars_vertex:vM,logdepthbuf_vertex:yM,map_fragment:bM,map_pars_fragment:SM,map_particle_fragment:MM,map_particle_pars_fragment:wM,metalnessmap_fragment:EM,metalnessmap_pars_fragment:TM,morphinstance_vertex:AM,morphcolor_vertex:CM,morphnormal_vertex:RM,morphtarget_pars_vertex:PM,morphtarget_vertex:IM,normal_fragment_begin:LM,normal_fragment_maps:DM,normal_pars_fragment:NM,normal_pars_vertex:UM,normal_vertex:FM,normalmap_pars_fragment:OM,clearcoat_normal_fragment_begin:kM,clearcoat_normal_fragment_maps:BM,clearcoat_pars_fragment:zM,iridescence_pars_fragment:VM,opaque_fragment:GM,packing:HM,premultiplied_alpha_fragment:WM,project_vertex:XM,dithering_fragment:qM,dithering_pars_fragment:YM,roughnessmap_fragment:$M,roughnessmap_pars_fragment:ZM,shadowmap_pars_fragment:KM,shadowmap_pars_vertex:JM,shadowmap_vertex:jM,shadowmask_pars_fragment:QM,skinbase_vertex:ew,skinning_pars_vertex:tw,skinning_vertex:nw,skinnormal_vertex:iw,specularmap_fragment:sw,specularmap_pars_fragment:rw,tonemapping_fragment:ow,tonemapping_pars_fragment:aw,transmission_fragment:lw,transmission_pars_fragment:cw,uv_pars_fragment:hw,uv_pars_vertex:uw,uv_vertex:dw,worldpos_vertex:fw,background_vert:pw,background_frag:mw,backgroundCube_vert:gw,backgroundCube_frag:_w,cube_vert:xw,cube_frag:vw,depth_vert:yw,depth_frag:bw,distance_vert:Sw,distance_frag:Mw,equirect_vert:ww,equirect_frag:Ew,linedashed_vert:Tw,linedashed_frag:Aw,meshbasic_vert:Cw,meshbasic_frag:Rw,meshlambert_vert:Pw,meshlambert_frag:Iw,meshmatcap_vert:Lw,meshmatcap_frag:Dw,meshnormal_vert:Nw,meshnormal_frag:Uw,meshphong_vert:Fw,meshphong_frag:Ow,meshphysical_vert:kw,meshphysical_frag:Bw,meshtoon_vert:zw,meshtoon_frag:Vw,points_vert:Gw,points_frag:Hw,shadow_vert:Ww,shadow_frag:Xw,sprite_vert:qw,sprite_frag:Yw},Le={common:{diffuse:{value:new ct(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new je(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ct(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ct(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new ct(16777215)},opacity:{value:1},center:{value:new je(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},cs={basic:{uniforms:zn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ut.meshbasic_vert,fragmentShader:ut.meshbasic_frag},lambert:{uniforms:zn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new ct(0)},envMapIntensity:{value:1}}]),vertexShader:ut.meshlambert_vert,fragmentShader:ut.meshlambert_frag},phong:{uniforms:zn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new ct(0)},specular:{value:new ct(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ut.meshphong_vert,fragmentShader:ut.meshphong_frag},standard:{uniforms:zn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new ct(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ut.meshphysical_vert,fragmentShader:ut.meshphysical_frag},toon:{uniforms:zn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new ct(0)}}]),vertexShader:ut.meshtoon_vert,fragmentShader:ut.meshtoon_frag},matcap:{uniforms:zn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ut.meshmatcap_vert,fragmentShader:ut.meshmatcap_frag},points:{uniforms:zn([Le.points,Le.fog]),vertexShader:ut.points_vert,fragmentShader:ut.points_frag},dashed:{uniforms:zn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ut.linedashed_vert,fragmentShader:ut.linedashed_frag},depth:{uniforms:zn([Le.common,Le.displacementmap]),vertexShader:ut.depth_vert,fragmentShader:ut.depth_frag},normal:{uniforms:zn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ut.meshnormal_vert,fragmentShader:ut.meshnormal_frag},sprite:{uniforms:zn([Le.sprite,Le.fog]),vertexShader:ut.sprite_vert,fragmentShader:ut.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ut.background_vert,fragmentShader:ut.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:ut.backgroundCube_vert,fragmentShader:ut.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ut.cube_vert,fragmentShader:ut.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ut.equirect_vert,fragmentShader:ut.equirect_frag},distance:{uniforms:zn([Le.common,Le.displacementmap,{referencePosition:{value:new Y},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ut.distance_vert,fragmentShader:ut.distance_frag},shadow:{uniforms:zn([Le.lights,Le.fog,{color:{value:new ct(0)},opacity:{value:1}}]),vertexShader:ut.shadow_vert,fragmentShader:ut.shadow_frag}};cs.physical={uniforms:zn([cs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new je(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new ct(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new je},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new ct(0)},specularColor:{value:new ct(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new je},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:ut.meshphysical_vert,fragmentShader:ut.meshphysical_frag};var ru={r:0,b:0,g:0},$w=new Rt,F_=new nt;F_.set(-1,0,0,0,1,0,0,0,1);function Zw(i,e,t,n,s,r){let o=new ct(0),a=s===!0?0:1,l,c,h=null,d=0,u=null;function p(y){let A=y.isScene===!0?y.background:null;if(A&&A.isTexture){let w=y.backgroundBlurriness>0;A=e.get(A,w)}return A}function g(y){let A=!1,w=p(y);w===null?f(o,a):w&&w.isColor&&(f(w,1),A=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(y,A){let w=p(A);w&&w.isCubeTexture?(c===void 0&&(c=new Kt(new tr(1,1,1),new os({name:"BackgroundCubeMaterial",uniforms:Ur(cs.backgroundCube.uniforms),vertexShader:cs.backgroundCube.vertexShader,fragmentShader:cs.backgroundCube.fragmentShader,side:jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=w,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4($w.makeRotationFromEuler(A.backgroundRotation)).transpose(),w.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(F_),c.material.toneMapped=vt.getTransfer(w.colorSpace)!==Ct,(h!==w||d!==w.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=w,d=w.version,u=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):w&&w.isTexture&&(l===void 0&&(l=new Kt(new rs(2,2),new os({name:"BackgroundMaterial",uniforms:Ur(cs.background.uniforms),vertexShader:cs.background.vertexShader,fragmentShader:cs.background.fragmentShader,side:ar,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=w,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=vt.getTransfer(w.colorSpace)!==Ct,w.matrixAutoUpdate===!0&&w.updateMatrix(),l.material.uniforms.uvTransform.value.copy(w.matrix),(h!==w||d!==w.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=w,d=w.version,u=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function f(y,A){y.getRGB(ru,Bf(i)),t.buffers.color.setClear(ru.r,ru.g,ru.b,A,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,A=1){o.set(y),a=A,f(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,f(o,a)},render:g,addToRenderList:v,dispose:m}}function Kw(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,o=!1;function a(D,W,H,I,O){let q=!1,z=d(D,I,H,W);r!==z&&(r=z,c(r.object)),q=p(D,I,H,O),q&&g(D,I,H,O),O!==null&&e.update(O,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,w(D,W,H,I),O!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(O).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function d(D,W,H,I){let O=I.wireframe===!0,q=n[W.id];q===void 0&&(q={},n[W.id]=q);let z=D.isInstancedMesh===!0?D.id:0,le=q[z];le===void 0&&(le={},q[z]=le);let K=le[H.id];K===void 0&&(K={},le[H.id]=K);let Q=K[O];return Q===void 0&&(Q=u(l()),K[O]=Q),Q}function u(D){let W=[],H=[],I=[];for(let O=0;O<t;O++)W[O]=0,H[O]=0,I[O]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:W,enabledAttributes:H,attributeDivisors:I,object:D,attributes:{},index:null}}function p(D,W,H,I){let O=r.attributes,q=W.attributes,z=0,le=H.getAttributes();for(let K in le)if(le[K].location>=0){let ie=O[K],de=q[K];if(de===void 0&&(K==="instanceMatrix"&&D.instanceMatrix&&(de=D.instanceMatrix),K==="instanceColor"&&D.instanceColor&&(de=D.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;z++}return r.attributesNum!==z||r.index!==I}function g(D,W,H,I){let O={},q=W.attributes,z=0,le=H.getAttributes();for(let K in le)if(le[K].location>=0){let ie=q[K];ie===void 0&&(K==="instanceMatrix"&&D.instanceMatrix&&(ie=D.instanceMatrix),K==="instanceColor"&&D.instanceColor&&(ie=D.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),O[K]=de,z++}r.attributes=O,r.attributesNum=z,r.index=I}function v(){let D=r.newAttributes;for(let W=0,H=D.length;W<H;W++)D[W]=0}function f(D){m(D,0)}function m(D,W){let H=r.newAttributes,I=r.enabledAttributes,O=r.attributeDivisors;H[D]=1,I[D]===0&&(i.enableVertexAttribArray(D),I[D]=1),O[D]!==W&&(i.vertexAttribDivisor(D,W),O[D]=W)}function y(){let D=r.newAttributes,W=r.enabledAttributes;for(let H=0,I=W.length;H<I;H++)W[H]!==D[H]&&(i.disableVertexAttribArray(H),W[H]=0)}function A(D,W,H,I,O,q,z){z===!0?i.vertexAttribIPointer(D,W,H,O,q):i.vertexAttribPointer(D,W,H,I,O,q)}function w(D,W,H,I){v();let O=I.attributes,q=H.getAttributes(),z=W.defaultAttributeValues;for(let le in q){let K=q[le];if(K.location>=0){let Q=O[le];if(Q===void 0&&(le==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),le==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let ie=Q.normalized,de=Q.itemSize,ue=e.get(Q);if(ue===void 0)continue;let ee=ue.buffer,me=ue.type,ge=ue.bytesPerElement,xe=me===i.INT||me===i.UNSIGNED_INT||Q.gpuType===bh;if(Q.isInterleavedBufferAttribute){let _e=Q.data,Ve=_e.isInterleavedBuffer===!0?_e.stride:_e.itemSize,$e=Q.offset;if(_e.isInstancedInterleavedBuffer||_e.isInstancedBufferAttribute){for(let Fe=0;Fe<K.locationSize;Fe++)m(K.location+Fe,_e.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=_e.meshPerAttribute*_e.count)}else for(let Fe=0;Fe<K.locationSize;Fe++)f(K.location+Fe);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Fe=0;Fe<K.locationSize;Fe++)A(K.location+Fe,de/K.locationSize,me,ie,Ve*ge,($e+de/K.locationSize*Fe)*ge,xe)}else{if(Q.isInstancedBufferAttribute){for(let _e=0;_e<K.locationSize;_e++)m(K.location+_e,Q.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let _e=0;_e<K.locationSize;_e++)f(K.location+_e);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let _e=0;_e<K.locationSize;_e++)A(K.location+_e,de/K.locationSize,me,ie,de*ge,de/K.locationSize*_e*ge,xe)}}else if(z!==void 0){let ie=z[le];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(K.location,ie);break;case 3:i.vertexAttrib3fv(K.location,ie);break;case 4:i.vertexAttrib4fv(K.location,ie);break;default:i.vertexAttrib1fv(K.location,ie)}}}}y()}function R(){B();for(let D in n){let W=n[D];for(let H in W){let I=W[H];for(let O in I){let q=I[O];for(let z in q)h(q[z].object),delete q[z];delete I[O]}}delete n[D]}}function E(D){if(n[D.id]===void 0)return;let W=n[D.id];for(let H in W){let I=W[H];for(let O in I){let q=I[O];for(let z in q)h(q[z].object),delete q[z];delete I[O]}}delete n[D.id]}function x(D){for(let W in n){let H=n[W];for(let I in H){let O=H[I];if(O[D.id]===void 0)continue;let q=O[D.id];for(let z in q)h(q[z].object),delete q[z];delete O[D.id]}}}function T(D){for(let W in n){let H=n[W],I=D.isInstancedMesh===!0?D.id:0,O=H[I];if(O!==void 0){for(let q in O){let z=O[q];for(let le in z)h(z[le].object),delete z[le];delete O[q]}delete H[I],Object.keys(H).length===0&&delete n[W]}}}function B(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:N,dispose:R,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:x,initAttributes:v,enableAttribute:f,disableUnusedAttributes:y}}function Jw(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let p=0;p<h;p++)u+=c[p];t.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function jw(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Xi&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let T=x===Wi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==ni&&x!==Ti&&!T&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(qe("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&qe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&qe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),f=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),w=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:f,maxAttributes:m,maxVertexUniforms:y,maxVaryings:A,maxFragmentUniforms:w,maxSamples:R,samples:E}}function Qw(i){let e=this,t=null,n=0,s=!1,r=!1,o=new pi,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let p=d.length!==0||u||n!==0||s;return s=u,n=d.length,p},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){t=h(d,u,0)},this.setState=function(d,u,p){let g=d.clippingPlanes,v=d.clipIntersection,f=d.clipShadows,m=i.get(d);if(!s||g===null||g.length===0||r&&!f)r?h(null):c();else{let y=r?0:n,A=y*4,w=m.clippingState||null;l.value=w,w=h(g,u,A,p);for(let R=0;R!==A;++R)w[R]=t[R];m.clippingState=w,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(d,u,p,g){let v=d!==null?d.length:0,f=null;if(v!==0){if(f=l.value,g!==!0||f===null){let m=p+v*4,y=u.matrixWorldInverse;a.getNormalMatrix(y),(f===null||f.length<m)&&(f=new Float32Array(m));for(let A=0,w=p;A!==v;++A,w+=4)o.copy(d[A]).applyMatrix4(y,a),o.normal.toArray(f,w),f[w+3]=o.constant}l.value=f,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,f}}var il=class extends mi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Oa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new tr(5,5,5),r=new os({name:"CubemapFromEquirect",uniforms:Ur(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:jn,blending:Ir});r.uniforms.tEquirect.value=t;let o=new Kt(s,r),a=t.minFilter;return t.minFilter===Ls&&(t.minFilter=Kn),new Uo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},p_=256,e1=3,t1=20,O_=256,k_=16,n1=3,i1=new Y,s1=new ct,au=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Uo(1,10,null),this._boxMesh=new Kt(new tr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=i1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,p=l.autoClearDepth,g=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(s1));let f=new Uo(n,s,h);return f.position.copy(a),f.update(l,e),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=p,l.autoClearStencil=g,e.background=v,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=__(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=g_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(p_,Ff(e))}_fromTexture(e,t){e.mapping===Dr||e.mapping===Bo?this._setSize(e.image.length===0?p_:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=m_(e,!1,!1),n=Math.log2(e)-e1;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=m_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Dr||e.mapping===Bo?(this._cubemapMaterial===null&&(this._cubemapMaterial=__()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=g_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=r1(),this._integrationMaterial=o1());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/k_);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-n1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(O_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=a1());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function m_(i,e,t){return new il(i,{minFilter:Ls,generateMipmaps:e,type:Wi,colorSpace:wa,depthBuffer:t})}function sl(i,e,t){return new os({name:i,uniforms:e,vertexShader:ut.cube_vert,fragmentShader:t,side:jn,blending:Ir,depthTest:!1,depthWrite:!1})}function r1(){return sl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${O_}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function o1(){return sl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:k_}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function a1(){return sl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${t1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function g_(){return sl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function __(){return sl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function l1(i){let e=new WeakMap,t=new WeakMap,n=null;function s(u,p=!1){return u==null?null:p?o(u):r(u)}function r(u){if(u&&u.isTexture){let p=u.mapping;if(p===xh||p===vh)if(e.has(u)){let g=e.get(u).texture;return a(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let v=new il(g.height);return v.fromEquirectangularTexture(i,u),e.set(u,v),u.addEventListener("dispose",c),a(v.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let p=u.mapping,g=p===xh||p===vh,v=p===Dr||p===Bo;if(g||v){let f=t.get(u),m=f!==void 0?f.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==m)return n===null&&(n=new au(i)),f=g?n.fromEquirectangular(u,f):n.fromCubemap(u,f),f.texture.pmremVersion=u.pmremVersion,t.set(u,f),f.texture;if(f!==void 0)return f.texture;{let y=u.image;return g&&y&&y.height>0||v&&y&&l(y)?(n===null&&(n=new au(i)),f=g?n.fromEquirectangular(u):n.fromCubemap(u),f.texture.pmremVersion=u.pmremVersion,t.set(u,f),u.addEventListener("dispose",h),f.texture):null}}}return u}function a(u,p){return p===xh?u.mapping=Dr:p===vh&&(u.mapping=Bo),u}function l(u){let p=0,g=6;for(let v=0;v<g;v++)u[v]!==void 0&&p++;return p===g}function c(u){let p=u.target;p.removeEventListener("dispose",c);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function h(u){let p=u.target;p.removeEventListener("dispose",h);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function c1(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&ba("WebGLRenderer: "+n+" extension not supported."),s}}}function h1(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let f in g.attributes)e.remove(g.attributes[f]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let v=r.get(g);v&&(e.remove(v),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function h(g){let v=g.attributes;for(let f in v)e.update(v[f],i.ARRAY_BUFFER)}function d(g){let v=g.index,f=g.attributes.position,m=0;if(f===void 0)return;let y=v!==null?v.array.length:f.array.length/3-1,A=f.count>=65535?La:Ia,w=new A(Math.ceil(y/3)*6,1),R=w.array;if(v!==null){let x=v.array;m=v.version;for(let T=0,B=0;T<y;T+=3){let N=x[T+0],D=x[T+1],W=x[T+2];R[B++]=N,R[B++]=D,R[B++]=D,R[B++]=W,R[B++]=W,R[B++]=N}}else{m=f.version;for(let x=0,T=0;x<y;x+=3){let B=x+0,N=x+1,D=x+2;R[T++]=B,R[T++]=N,R[T++]=N,R[T++]=D,R[T++]=D,R[T++]=B}}w.version=m;let E=r.get(g);E&&e.remove(E),r.set(g,w)}function u(g){let v=r.get(g);if(v){let f=g.index;f!==null&&v.version<f.version&&d(g)}else d(g);return r.get(g)}function p(){for(let g in s){let v=s[g].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:u,dispose:p}}function u1(i,e,t){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){i.drawElements(n,u,r,d*o),t.update(u,n,1)}function c(d,u,p){p!==0&&(i.drawElementsInstanced(n,u,r,d*o,p),t.update(u,n,p))}function h(d,u,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,p);let v=0;for(let f=0;f<p;f++)v+=u[f];t.update(v,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function d1(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function f1(i,e,t){let n=new WeakMap,s=new $t;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==d){let B=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",B)};u!==void 0&&u.texture.dispose();let p=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,f=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],A=0;p===!0&&(A=1),g===!0&&(A=2),v===!0&&(A=3);let w=a.attributes.position.count*A,R=1;w>e.maxTextureSize&&(R=Math.ceil(w/e.maxTextureSize),w=e.maxTextureSize);let E=new Float32Array(w*R*4*d),x=new Aa(E,w,R,d);x.type=Ti,x.needsUpdate=!0;let T=A*4;for(let N=0;N<d;N++){let D=f[N],W=m[N],H=y[N],I=w*R*4*N;for(let O=0;O<D.count;O++){let q=O*T;p===!0&&(s.fromBufferAttribute(D,O),E[I+q+0]=s.x,E[I+q+1]=s.y,E[I+q+2]=s.z,E[I+q+3]=0),g===!0&&(s.fromBufferAttribute(W,O),E[I+q+4]=s.x,E[I+q+5]=s.y,E[I+q+6]=s.z,E[I+q+7]=0),v===!0&&(s.fromBufferAttribute(H,O),E[I+q+8]=s.x,E[I+q+9]=s.y,E[I+q+10]=s.z,E[I+q+11]=H.itemSize===4?s.w:1)}}u={count:d,texture:x,size:new je(w,R)},n.set(a,u),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let p=0;for(let v=0;v<c.length;v++)p+=c[v];let g=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function p1(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,d=c.geometry,u=e.get(c,d);if(r.get(u)!==h&&(e.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==h&&(p.update(),r.set(p,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var m1={[gf]:"LINEAR_TONE_MAPPING",[_f]:"REINHARD_TONE_MAPPING",[xf]:"CINEON_TONE_MAPPING",[vf]:"ACES_FILMIC_TONE_MAPPING",[bf]:"AGX_TONE_MAPPING",[Sf]:"NEUTRAL_TONE_MAPPING",[yf]:"CUSTOM_TONE_MAPPING"};function g1(i,e,t,n,s,r){let o=new mi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Fn;h.setAttribute("position",new Ln([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ln([0,2,0,0,2,0],2));let d=new th({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new Kt(h,d),p=new Xa(-1,1,1,-1,0,1),g=null,v=null,f=!1,m,y=null,A=[],w=!1;this.setSize=function(R,E){o.setSize(R,E),a!==null&&a.setSize(R,E),l!==null&&l.setSize(R,E);for(let x=0;x<A.length;x++){let T=A[x];T.setSize&&T.setSize(R,E)}},this.setEffects=function(R){A=R,w=A.length>0&&A[0].isRenderPass===!0;let E=o.width,x=o.height;A.length>0&&a===null&&(a=new mi(E,x,{type:Wi,depthBuffer:!1,stencilBuffer:!1}),l=new mi(E,x,{type:Wi,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&A.some(B=>B.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Is(E,x),r===!0&&(c.format=Ds,c.type=Nr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let B=0;B<A.length;B++){let N=A[B];N.setSize&&N.setSize(E,x),T&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(R,E){if(f||R.toneMapping===as&&A.length===0)return!1;if(y=E,E!==null){let x=E.width,T=E.height;(o.width!==x||o.height!==T)&&this.setSize(x,T)}return w===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=as,!0},this.hasRenderPass=function(){return w},this.end=function(R,E){R.toneMapping=m,f=!0;let x=o,T=a;for(let B=0;B<A.length;B++){let N=A[B];N.enabled!==!1&&(N.render(R,T,x,E),N.needsSwap!==!1&&(x=T,T=T===a?l:a))}if(g!==R.outputColorSpace||v!==R.toneMapping){g=R.outputColorSpace,v=R.toneMapping,d.defines={},vt.getTransfer(g)===Ct&&(d.defines.SRGB_TRANSFER="");let B=m1[v];B&&(d.defines[B]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=x.texture,R.setRenderTarget(y),R.render(u,p),y=null,f=!1},this.isCompositing=function(){return f},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var B_=new ei,z_=new Is(1,1),V_=new ka(1),G_=new Aa,H_=new Jc,W_=new Oa,x_=[],v_=[],y_=new Float32Array(16),b_=new Float32Array(9),S_=new Float32Array(4);function Ho(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=x_[s];if(r===void 0&&(r=new Float32Array(s),x_[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function bn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Sn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function cu(i,e){let t=v_[e];t===void 0&&(t=new Int32Array(e),v_[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function _1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function x1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bn(t,e))return;i.uniform2fv(this.addr,e),Sn(t,e)}}function v1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(bn(t,e))return;i.uniform3fv(this.addr,e),Sn(t,e)}}function y1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bn(t,e))return;i.uniform4fv(this.addr,e),Sn(t,e)}}function b1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(bn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Sn(t,e)}else{if(bn(t,n))return;S_.set(n),i.uniformMatrix2fv(this.addr,!1,S_),Sn(t,n)}}function S1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(bn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Sn(t,e)}else{if(bn(t,n))return;b_.set(n),i.uniformMatrix3fv(this.addr,!1,b_),Sn(t,n)}}function M1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(bn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Sn(t,e)}else{if(bn(t,n))return;y_.set(n),i.uniformMatrix4fv(this.addr,!1,y_),Sn(t,n)}}function w1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function E1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bn(t,e))return;i.uniform2iv(this.addr,e),Sn(t,e)}}function T1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(bn(t,e))return;i.uniform3iv(this.addr,e),Sn(t,e)}}function A1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bn(t,e))return;i.uniform4iv(this.addr,e),Sn(t,e)}}function C1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function R1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bn(t,e))return;i.uniform2uiv(this.addr,e),Sn(t,e)}}function P1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(bn(t,e))return;i.uniform3uiv(this.addr,e),Sn(t,e)}}function I1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bn(t,e))return;i.uniform4uiv(this.addr,e),Sn(t,e)}}function hu(i){return i.version===0&&(i.compareFunction=Lf,i.needsUpdate=!0),i}function L1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=hu(z_):r=B_,t.setTexture2D(e||r,s)}function D1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||H_,s)}function N1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=hu(V_):r=W_,t.setTextureCube(e||r,s)}function U1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||G_,s)}function F1(i){switch(i){case 5126:return _1;case 35664:return x1;case 35665:return v1;case 35666:return y1;case 35674:return b1;case 35675:return S1;case 35676:return M1;case 5124:case 35670:return w1;case 35667:case 35671:return E1;case 35668:case 35672:return T1;case 35669:case 35673:return A1;case 5125:return C1;case 36294:return R1;case 36295:return P1;case 36296:return I1;case 35678:case 36198:case 36298:case 36306:case 35682:return L1;case 35679:case 36299:case 36307:return D1;case 35680:case 36300:case 36308:case 36293:return N1;case 36289:case 36303:case 36311:case 36292:return U1}}function O1(i,e){i.uniform1fv(this.addr,e)}function k1(i,e){let t=Ho(e,this.size,2);i.uniform2fv(this.addr,t)}function B1(i,e){let t=Ho(e,this.size,3);i.uniform3fv(this.addr,t)}function z1(i,e){let t=Ho(e,this.size,4);i.uniform4fv(this.addr,t)}function V1(i,e){let t=Ho(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function G1(i,e){let t=Ho(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function H1(i,e){let t=Ho(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function W1(i,e){i.uniform1iv(this.addr,e)}function X1(i,e){i.uniform2iv(this.addr,e)}function q1(i,e){i.uniform3iv(this.addr,e)}function Y1(i,e){i.uniform4iv(this.addr,e)}function $1(i,e){i.uniform1uiv(this.addr,e)}function Z1(i,e){i.uniform2uiv(this.addr,e)}function K1(i,e){i.uniform3uiv(this.addr,e)}function J1(i,e){i.uniform4uiv(this.addr,e)}function j1(i,e,t){let n=this.cache,s=e.length,r=cu(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=hu(z_):o=B_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Q1(i,e,t){let n=this.cache,s=e.length,r=cu(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||H_,r[o])}function eE(i,e,t){let n=this.cache,s=e.length,r=cu(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=hu(V_):o=W_;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function tE(i,e,t){let n=this.cache,s=e.length,r=cu(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||G_,r[o])}function nE(i){switch(i){case 5126:return O1;case 35664:return k1;case 35665:return B1;case 35666:return z1;case 35674:return V1;case 35675:return G1;case 35676:return H1;case 5124:case 35670:return W1;case 35667:case 35671:return X1;case 35668:case 35672:return q1;case 35669:case 35673:return Y1;case 5125:return $1;case 36294:return Z1;case 36295:return K1;case 36296:return J1;case 35678:case 36198:case 36298:case 36306:case 35682:return j1;case 35679:case 36299:case 36307:return Q1;case 35680:case 36300:case 36308:case 36293:return eE;case 36289:case 36303:case 36311:case 36292:return tE}}var Kf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=F1(t.type)}},Jf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=nE(t.type)}},jf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},$f=/(\w+)(\])?(\[|\.)?/g;function M_(i,e){i.seq.push(e),i.map[e.id]=e}function iE(i,e,t){let n=i.name,s=n.length;for($f.lastIndex=0;;){let r=$f.exec(n),o=$f.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){M_(t,c===void 0?new Kf(a,i,e):new Jf(a,i,e));break}else{let d=t.map[a];d===void 0&&(d=new jf(a),M_(t,d)),t=d}}}var Go=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);iE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function w_(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var sE=37297,rE=0;function oE(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var E_=new nt;function aE(i){vt._getMatrix(E_,vt.workingColorSpace,i);let e=`mat3( ${E_.elements.map(t=>t.toFixed(4))} )`;switch(vt.getTransfer(i)){case Ea:return[e,"LinearTransferOETF"];case Ct:return[e,"sRGBTransferOETF"];default:return qe("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function T_(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+oE(i.getShaderSource(e),a)}else return r}function lE(i,e){let t=aE(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var cE={[gf]:"Linear",[_f]:"Reinhard",[xf]:"Cineon",[vf]:"ACESFilmic",[bf]:"AgX",[Sf]:"Neutral",[yf]:"Custom"};function hE(i,e){let t=cE[e];return t===void 0?(qe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var ou=new Y;function uE(){vt.getLuminanceCoefficients(ou);let i=ou.x.toFixed(4),e=ou.y.toFixed(4),t=ou.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function dE(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(nl).join(`
`)}function fE(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function pE(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function nl(i){return i!==""}function A_(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function C_(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var mE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Qf(i){return i.replace(mE,gE)}function gE(i,e){let t=ut[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Qf(t)}var _E=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function R_(i){return i.replace(_E,xE)}function xE(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function P_(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var vE={[Pr]:"SHADOWMAP_TYPE_PCF",[Oo]:"SHADOWMAP_TYPE_VSM"};function yE(i){return vE[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var bE={[Bo]:"ENVMAP_MODE_REFRACTION"};function SE(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":bE[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var ME={[_h]:"ENVMAP_BLENDING_MULTIPLY",[q0]:"ENVMAP_BLENDING_MIX",[Y0]:"ENVMAP_BLENDING_ADD"};function wE(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":ME[i.combine]||"ENVMAP_BLENDING_NONE"}function EE(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=yE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=SE(t),d=wE(t),u=dE(t),p=fE(r),g=s.createProgram(),v,f,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(nl).join(`
`),v.length>0&&(v+=`
`),f=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(nl).join(`
`),f.length>0&&(f+=`
`)):(v=[P_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(nl).join(`
`),f=[P_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==as?"#define TONE_MAPPING":"",t.toneMapping!==as?ut.tonemapping_pars_fragment:"",t.toneMapping!==as?hE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ut.colorspace_pars_fragment,lE("linearToOutputTexel",t.outputColorSpace),uE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(nl).join(`
`)),o=Qf(o),o=A_(o,t),o=C_(o,t),a=Qf(a),a=A_(a,t),a=C_(a,t),o=R_(o),a=R_(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,v=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,f=["#define varying in",t.glslVersion===Df?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Df?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);let y=m+v+o,A=m+f+a,w=w_(s,s.VERTEX_SHADER,y),R=w_(s,s.FRAGMENT_SHADER,A);s.attachShader(g,w),s.attachShader(g,R),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(N){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",W=s.getShaderInfoLog(w)||"",H=s.getShaderInfoLog(R)||"",I=D.trim(),O=W.trim(),q=H.trim(),z=!0,le=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,w,R);else{let K=T_(s,w,"vertex"),Q=T_(s,R,"fragment");tt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+I+`
`+K+`
`+Q)}else I!==""?qe("WebGLProgram: Program Info Log:",I):(O===""||q==="")&&(le=!1);le&&(N.diagnostics={runnable:z,programLog:I,vertexShader:{log:O,prefix:v},fragmentShader:{log:q,prefix:f}})}s.deleteShader(w),s.deleteShader(R),x=new Go(s,g),T=pE(s,g)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(g,sE)),B},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=rE++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=w,this.fragmentShader=R,this}var TE=0,ep=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new tp(e),t.set(e,n)),n}},tp=class{constructor(e){this.id=TE++,this.code=e,this.usedTimes=0}};function AE(i){return i===lr||i===Qa||i===el}function CE(i,e,t,n,s,r){let o=new Ca,a=new ep,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,T,B,N,D,W){let H=N.fog,I=D.geometry,O=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?N.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,z=e.get(x.envMap||O,q),le=u[x.type],K=n.precision;x.precision!==null&&(K=n.getMaxPrecision(x.precision),K!==x.precision&&qe("WebGLProgram.getParameters:",x.precision,"not supported, using",K,"instead."));let Q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ie=Q!==void 0?Q.length:0,de=0;I.morphAttributes.position!==void 0&&(de=1),I.morphAttributes.normal!==void 0&&(de=2),I.morphAttributes.color!==void 0&&(de=3);let ue,ee,me,ge;if(le){let Ce=cs[le];ue=Ce.vertexShader,ee=Ce.fragmentShader}else{ue=x.vertexShader,ee=x.fragmentShader;let Ce=a.getVertexShaderStage(x),lt=a.getFragmentShaderStage(x);a.update(x,Ce,lt),me=Ce.id,ge=lt.id}let xe=i.getRenderTarget(),_e=i.state.buffers.depth.getReversed(),Ve=D.isInstancedMesh===!0,$e=D.isBatchedMesh===!0,Fe=!!x.map,it=!!x.matcap,at=!!z,st=at&&z.isPMREMTexture===!0,qt=!!x.aoMap,kt=!!x.lightMap,an=!!x.bumpMap&&x.wireframe===!1,Dt=!!x.normalMap,wn=!!x.displacementMap,bt=!!x.emissiveMap,_n=!!x.metalnessMap,Jt=!!x.roughnessMap,ln=x.anisotropy>0,F=x.clearcoat>0,Re=x.diffuseRoughness>0,Ye=x.dispersion>0,ot=x.retroreflectivity>0,we=x.iridescence>0,Ut=x.sheen>0,Ge=x.transmission>0,Xe=ln&&!!x.anisotropyMap,C=F&&!!x.clearcoatMap,b=F&&!!x.clearcoatNormalMap,X=F&&!!x.clearcoatRoughnessMap,he=Re&&!!x.diffuseRoughnessMap,oe=we&&!!x.iridescenceMap,ye=we&&!!x.iridescenceThicknessMap,be=Ut&&!!x.sheenColorMap,te=Ut&&!!x.sheenRoughnessMap,se=!!x.specularMap,pe=!!x.specularColorMap,U=!!x.specularIntensityMap,re=Ge&&!!x.transmissionMap,ne=Ge&&!!x.thicknessMap,Ee=!!x.gradientMap,ve=!!x.alphaMap,Me=x.alphaTest>0,He=!!x.alphaHash,Ke=!!x.extensions,ce=as;x.toneMapped&&(xe===null||xe.isXRRenderTarget===!0)&&(ce=i.toneMapping);let ke=st?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,Je={shaderID:le,shaderType:x.type,shaderName:x.name,vertexShader:ue,fragmentShader:ee,defines:x.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:K,batching:$e,batchingColor:$e&&D._colorsTexture!==null,instancing:Ve,instancingColor:Ve&&D.instanceColor!==null,instancingMorph:Ve&&D.morphTexture!==null,outputColorSpace:xe===null?i.outputColorSpace:xe.isXRRenderTarget===!0?xe.texture.colorSpace:vt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Fe,matcap:it,envMap:at,envMapMode:at&&z.mapping,envMapPMREM:st,envMapMaxLod:st?ke.length-1:null,envMapSize:st?ke[0].width:null,aoMap:qt,lightMap:kt,bumpMap:an,normalMap:Dt,displacementMap:wn,emissiveMap:bt,normalMapObjectSpace:Dt&&x.normalMapType===K0,normalMapTangentSpace:Dt&&x.normalMapType===su,packedNormalMap:Dt&&x.normalMapType===su&&AE(x.normalMap.format),metalnessMap:_n,roughnessMap:Jt,anisotropy:ln,anisotropyMap:Xe,clearcoat:F,clearcoatMap:C,clearcoatNormalMap:b,clearcoatRoughnessMap:X,diffuseRoughness:Re,diffuseRoughnessMap:he,dispersion:Ye,retroreflection:ot,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:ye,sheen:Ut,sheenColorMap:be,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:U,transmission:Ge,transmissionMap:re,thicknessMap:ne,gradientMap:Ee,opaque:x.transparent===!1&&x.blending===ko&&x.alphaToCoverage===!1,alphaMap:ve,alphaTest:Me,alphaHash:He,combine:x.combine,mapUv:Fe&&p(x.map.channel),aoMapUv:qt&&p(x.aoMap.channel),lightMapUv:kt&&p(x.lightMap.channel),bumpMapUv:an&&p(x.bumpMap.channel),normalMapUv:Dt&&p(x.normalMap.channel),displacementMapUv:wn&&p(x.displacementMap.channel),emissiveMapUv:bt&&p(x.emissiveMap.channel),metalnessMapUv:_n&&p(x.metalnessMap.channel),roughnessMapUv:Jt&&p(x.roughnessMap.channel),anisotropyMapUv:Xe&&p(x.anisotropyMap.channel),clearcoatMapUv:C&&p(x.clearcoatMap.channel),clearcoatNormalMapUv:b&&p(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&p(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&p(x.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&p(x.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&p(x.iridescenceThicknessMap.channel),sheenColorMapUv:be&&p(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&p(x.sheenRoughnessMap.channel),specularMapUv:se&&p(x.specularMap.channel),specularColorMapUv:pe&&p(x.specularColorMap.channel),specularIntensityMapUv:U&&p(x.specularIntensityMap.channel),transmissionMapUv:re&&p(x.transmissionMap.channel),thicknessMapUv:ne&&p(x.thicknessMap.channel),alphaMapUv:ve&&p(x.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Dt||ln),vertexNormals:!!I.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!I.attributes.uv&&(Fe||ve),fog:!!H,useFog:x.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||I.attributes.normal===void 0&&Dt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:_e,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:W.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&B.length>0,shadowMapType:i.shadowMap.type,toneMapping:ce,decodeVideoTexture:Fe&&x.map.isVideoTexture===!0&&vt.getTransfer(x.map.colorSpace)===Ct,decodeVideoTextureEmissive:bt&&x.emissiveMap.isVideoTexture===!0&&vt.getTransfer(x.emissiveMap.colorSpace)===Ct,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===ti,flipSided:x.side===jn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Ke&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ke&&x.extensions.multiDraw===!0||$e)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Je.vertexUv1s=l.has(1),Je.vertexUv2s=l.has(2),Je.vertexUv3s=l.has(3),l.clear(),Je}function v(x){let T=[];if(x.shaderID?T.push(x.shaderID):(T.push(x.customVertexShaderID),T.push(x.customFragmentShaderID)),x.defines!==void 0)for(let B in x.defines)T.push(B),T.push(x.defines[B]);return x.isRawShaderMaterial===!1&&(f(T,x),m(T,x),T.push(i.outputColorSpace)),T.push(x.customProgramCacheKey),T.join()}function f(x,T){x.push(T.precision),x.push(T.outputColorSpace),x.push(T.envMapMode),x.push(T.envMapPMREM),x.push(T.envMapMaxLod),x.push(T.envMapSize),x.push(T.mapUv),x.push(T.alphaMapUv),x.push(T.lightMapUv),x.push(T.aoMapUv),x.push(T.bumpMapUv),x.push(T.normalMapUv),x.push(T.displacementMapUv),x.push(T.emissiveMapUv),x.push(T.metalnessMapUv),x.push(T.roughnessMapUv),x.push(T.anisotropyMapUv),x.push(T.clearcoatMapUv),x.push(T.clearcoatNormalMapUv),x.push(T.clearcoatRoughnessMapUv),x.push(T.diffuseRoughnessMapUv),x.push(T.iridescenceMapUv),x.push(T.iridescenceThicknessMapUv),x.push(T.sheenColorMapUv),x.push(T.sheenRoughnessMapUv),x.push(T.specularMapUv),x.push(T.specularColorMapUv),x.push(T.specularIntensityMapUv),x.push(T.transmissionMapUv),x.push(T.thicknessMapUv),x.push(T.combine),x.push(T.fogExp2),x.push(T.sizeAttenuation),x.push(T.morphTargetsCount),x.push(T.numSunLights),x.push(T.numDirLights),x.push(T.numPointLights),x.push(T.numSpotLights),x.push(T.numSpotLightMaps),x.push(T.numHemiLights),x.push(T.numRectAreaLights),x.push(T.numSunLightShadows),x.push(T.numDirLightShadows),x.push(T.numPointLightShadows),x.push(T.numSpotLightShadows),x.push(T.numSpotLightShadowsWithMaps),x.push(T.numLightProbes),x.push(T.numLightProbeGrids),x.push(T.shadowMapType),x.push(T.toneMapping),x.push(T.numClippingPlanes),x.push(T.numClipIntersection),x.push(T.depthPacking)}function m(x,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let T=u[x.type],B;if(T){let N=cs[T];B=u_.clone(N.uniforms)}else B=x.uniforms;return B}function A(x,T){let B=h.get(T);return B!==void 0?++B.usedTimes:(B=new EE(i,T,x,s),c.push(B),h.set(T,B)),B}function w(x){if(--x.usedTimes===0){let T=c.indexOf(x);c[T]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function R(x){a.remove(x)}function E(){a.dispose()}return{getParameters:g,getProgramCacheKey:v,getUniforms:y,acquireProgram:A,releaseProgram:w,releaseShaderCache:R,programs:c,dispose:E}}function RE(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function PE(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function I_(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function L_(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(u){let p=0;return u.isInstancedMesh&&(p+=2),u.isSkinnedMesh&&(p+=1),p}function a(u,p,g,v,f,m){let y=i[e];return y===void 0?(y={id:u.id,object:u,geometry:p,material:g,materialVariant:o(u),groupOrder:v,renderOrder:u.renderOrder,z:f,group:m},i[e]=y):(y.id=u.id,y.object=u,y.geometry=p,y.material=g,y.materialVariant=o(u),y.groupOrder=v,y.renderOrder=u.renderOrder,y.z=f,y.group=m),e++,y}function l(u,p,g,v,f,m,y){y.reversedDepth===!0&&(f=-f);let A=a(u,p,g,v,f,m);g.transmission>0?n.push(A):g.transparent===!0?s.push(A):t.push(A)}function c(u,p,g,v,f,m){let y=a(u,p,g,v,f,m);g.transmission>0?n.unshift(y):g.transparent===!0?s.unshift(y):t.unshift(y)}function h(u,p){t.length>1&&t.sort(u||PE),n.length>1&&n.sort(p||I_),s.length>1&&s.sort(p||I_)}function d(){for(let u=e,p=i.length;u<p;u++){let g=i[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function IE(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new L_,i.set(n,[o])):s>=r.length?(o=new L_,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function LE(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new Y,color:new ct};break;case"SpotLight":t={position:new Y,direction:new Y,color:new ct,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new Y,color:new ct,distance:0,decay:0};break;case"HemisphereLight":t={direction:new Y,skyColor:new ct,groundColor:new ct};break;case"RectAreaLight":t={color:new ct,position:new Y,halfWidth:new Y,halfHeight:new Y};break}return i[e.id]=t,t}}}function DE(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var NE=0;function UE(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function FE(i){let e=new LE,t=DE(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new Y);let s=new Y,r=new Rt,o=new Rt;function a(c){let h=0,d=0,u=0;for(let W=0;W<9;W++)n.probe[W].set(0,0,0);let p=0,g=0,v=0,f=0,m=0,y=0,A=0,w=0,R=0,E=0,x=0,T=0,B=0,N=0;c.sort(UE);for(let W=0,H=c.length;W<H;W++){let I=c[W],O=I.color,q=I.intensity,z=I.distance,le=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===lr?le=I.shadow.map.texture:le=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=O.r*q,d+=O.g*q,u+=O.b*q;else if(I.isLightProbe){for(let K=0;K<9;K++)n.probe[K].addScaledVector(I.sh.coefficients[K],q);N++}else if(I.isSunLight){let K=e.get(I);if(K.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=ie,n.sunShadowMap[g]=le;let de=Q.getViewportCount();for(let ue=0;ue<de;ue++)n.sunShadowMatrix[v+ue]=Q.getMatrix(ue),n.sunShadowCascade[v+ue]=Q._cascadeData[ue];v+=de,g++}n.sun[p]=K,p++}else if(I.isDirectionalLight){let K=e.get(I);if(K.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.directionalShadow[f]=ie,n.directionalShadowMap[f]=le,n.directionalShadowMatrix[f]=I.shadow.matrix,R++}n.directional[f]=K,f++}else if(I.isSpotLight){let K=e.get(I);K.position.setFromMatrixPosition(I.matrixWorld),K.color.copy(O).multiplyScalar(q),K.distance=z,K.coneCos=Math.cos(I.angle),K.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),K.decay=I.decay,n.spot[y]=K;let Q=I.shadow;if(I.map&&(n.spotLightMap[T]=I.map,T++,Q.updateMatrices(I),I.castShadow&&B++),n.spotLightMatrix[y]=Q.matrix,I.castShadow){let ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.spotShadow[y]=ie,n.spotShadowMap[y]=le,x++}y++}else if(I.isRectAreaLight){let K=e.get(I);K.color.copy(O).multiplyScalar(q),K.halfWidth.set(I.width*.5,0,0),K.halfHeight.set(0,I.height*.5,0),n.rectArea[A]=K,A++}else if(I.isPointLight){let K=e.get(I);if(K.color.copy(I.color).multiplyScalar(I.intensity),K.distance=I.distance,K.decay=I.decay,I.castShadow){let Q=I.shadow,ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,n.pointShadow[m]=ie,n.pointShadowMap[m]=le,n.pointShadowMatrix[m]=I.shadow.matrix,E++}n.point[m]=K,m++}else if(I.isHemisphereLight){let K=e.get(I);K.skyColor.copy(I.color).multiplyScalar(q),K.groundColor.copy(I.groundColor).multiplyScalar(q),n.hemi[w]=K,w++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Le.LTC_FLOAT_1,n.rectAreaLTC2=Le.LTC_FLOAT_2):(n.rectAreaLTC1=Le.LTC_HALF_1,n.rectAreaLTC2=Le.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let D=n.hash;(D.sunLength!==p||D.directionalLength!==f||D.pointLength!==m||D.spotLength!==y||D.rectAreaLength!==A||D.hemiLength!==w||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==E||D.numSpotShadows!==x||D.numSpotMaps!==T||D.numLightProbes!==N)&&(n.sun.length=p,n.directional.length=f,n.spot.length=y,n.rectArea.length=A,n.point.length=m,n.hemi.length=w,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+T-B,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=B,n.numLightProbes=N,D.sunLength=p,D.directionalLength=f,D.pointLength=m,D.spotLength=y,D.rectAreaLength=A,D.hemiLength=w,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=E,D.numSpotShadows=x,D.numSpotMaps=T,D.numLightProbes=N,n.version=NE++)}function l(c,h){let d=0,u=0,p=0,g=0,v=0,f=0,m=h.matrixWorldInverse;for(let y=0,A=c.length;y<A;y++){let w=c[y];if(w.isSunLight){let R=n.sun[d];R.direction.setFromMatrixPosition(w.matrixWorld),R.direction.transformDirection(m),d++}else if(w.isDirectionalLight){let R=n.directional[u];R.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),u++}else if(w.isSpotLight){let R=n.spot[g];R.position.setFromMatrixPosition(w.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),g++}else if(w.isRectAreaLight){let R=n.rectArea[v];R.position.setFromMatrixPosition(w.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(w.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(w.width*.5,0,0),R.halfHeight.set(0,w.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),v++}else if(w.isPointLight){let R=n.point[p];R.position.setFromMatrixPosition(w.matrixWorld),R.position.applyMatrix4(m),p++}else if(w.isHemisphereLight){let R=n.hemi[f];R.direction.setFromMatrixPosition(w.matrixWorld),R.direction.transformDirection(m),f++}}}return{setup:a,setupView:l,state:n}}function D_(i){let e=new FE(i),t=[],n=[],s=[];function r(d){h.camera=d,t.length=0,n.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){n.push(d)}function l(){e.setup(t),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function OE(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new D_(i),e.set(s,[a])):r>=o.length?(a=new D_(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var kE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,BE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,zE=[new Y(1,0,0),new Y(-1,0,0),new Y(0,1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1)],VE=[new Y(0,-1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1),new Y(0,-1,0),new Y(0,-1,0)],N_=new Rt,tl=new Y,Zf=new Y;function GE(i,e,t){let n=new er,s=new je,r=new je,o=new $t,a=new nh,l=new ih,c={},h=t.maxTextureSize,d={[ar]:jn,[jn]:ar,[ti]:ti},u=new os({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new je},radius:{value:4}},vertexShader:kE,fragmentShader:BE}),p=u.clone();p.defines.HORIZONTAL_PASS=1;let g=new Fn;g.setAttribute("position",new In(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Kt(g,u),f=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Pr;let m=this.type;this.render=function(E,x,T){if(f.enabled===!1||f.autoUpdate===!1&&f.needsUpdate===!1||E.length===0)return;this.type===A0&&(qe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Pr);let B=i.getRenderTarget(),N=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),W=i.state;W.setBlending(Ir),W.buffers.depth.getReversed()===!0?W.buffers.color.setClear(0,0,0,0):W.buffers.color.setClear(1,1,1,1),W.buffers.depth.setTest(!0),W.setScissorTest(!1);let H=m!==this.type;H&&x.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(O=>O.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,O=E.length;I<O;I++){let q=E[I],z=q.shadow;if(z===void 0){qe("WebGLShadowMap:",q,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let le=z.getFrameExtents();s.multiply(le),r.copy(z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/le.x),s.x=r.x*le.x,z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/le.y),s.y=r.y*le.y,z.mapSize.y=r.y));let K=i.state.buffers.depth.getReversed();if(z.camera._reversedDepth=K,z.map===null||H===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===Oo){if(q.isPointLight){qe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new mi(s.x,s.y,{format:lr,type:Wi,minFilter:Kn,magFilter:Kn,generateMipmaps:!1}),z.map.texture.name=q.name+".shadowMap",z.map.depthTexture=new Is(s.x,s.y,Ti),z.map.depthTexture.name=q.name+".shadowMapDepth",z.map.depthTexture.format=As,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=mn,z.map.depthTexture.magFilter=mn}else q.isPointLight?(z.map=new il(s.x),z.map.depthTexture=new ka(s.x,Hi)):(z.map=new mi(s.x,s.y),z.map.depthTexture=new Is(s.x,s.y,Hi)),z.map.depthTexture.name=q.name+".shadowMap",z.map.depthTexture.format=As,this.type===Pr?(z.map.depthTexture.compareFunction=K?If:Pf,z.map.depthTexture.minFilter=Kn,z.map.depthTexture.magFilter=Kn):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=mn,z.map.depthTexture.magFilter=mn);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let Q=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();q.isPointLight!==!0&&z.updateMatrices(q,T);let ie=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:T.layers;for(let de=0;de<Q;de++){let ue=z.getCamera(de);if(q.isPointLight){let ee=z.camera,me=z.matrix,ge=q.distance||ee.far;ge!==ee.far&&(ee.far=ge,ee.updateProjectionMatrix()),tl.setFromMatrixPosition(q.matrixWorld),ee.position.copy(tl),Zf.copy(ee.position),Zf.add(zE[de]),ee.up.copy(VE[de]),ee.lookAt(Zf),ee.updateMatrixWorld(),me.makeTranslation(-tl.x,-tl.y,-tl.z),N_.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),z._frustum.setFromProjectionMatrix(N_,ee.coordinateSystem,ee.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)i.setRenderTarget(z.map,de),i.clear();else{de===0&&(i.setRenderTarget(z.map),i.clear());let ee=z.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),W.viewport(o)}n=z.getFrustum(de),w(x,T,ue,q,ie,this.type)}z.isPointLightShadow!==!0&&this.type===Oo&&y(z,T),z.needsUpdate=!1}m=this.type,f.needsUpdate=!1,i.setRenderTarget(B,N,D)};function y(E,x){let T=e.update(v);u.defines.VSM_SAMPLES!==E.blurSamples&&(u.defines.VSM_SAMPLES=E.blurSamples,p.defines.VSM_SAMPLES=E.blurSamples,u.needsUpdate=!0,p.needsUpdate=!0),E.mapPass===null?E.mapPass=new mi(s.x,s.y,{format:lr,type:Wi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),u.uniforms.shadow_pass.value=E.map.depthTexture,u.uniforms.resolution.value.set(E.map.width,E.map.height),u.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(x,null,T,u,v,null),p.uniforms.shadow_pass.value=E.mapPass.texture,p.uniforms.resolution.value.set(E.map.width,E.map.height),p.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(x,null,T,p,v,null)}function A(E,x,T,B){let N=null,D=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)N=D;else if(N=T.isPointLight===!0?l:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let W=N.uuid,H=x.uuid,I=c[W];I===void 0&&(I={},c[W]=I);let O=I[H];O===void 0&&(O=N.clone(),I[H]=O,x.addEventListener("dispose",R)),N=O}if(N.visible=x.visible,N.wireframe=x.wireframe,B===Oo?N.side=x.shadowSide!==null?x.shadowSide:x.side:N.side=x.shadowSide!==null?x.shadowSide:d[x.side],N.alphaMap=x.alphaMap,N.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,N.map=x.map,N.clipShadows=x.clipShadows,N.clippingPlanes=x.clippingPlanes,N.clipIntersection=x.clipIntersection,N.displacementMap=x.displacementMap,N.displacementScale=x.displacementScale,N.displacementBias=x.displacementBias,N.wireframeLinewidth=x.wireframeLinewidth,N.linewidth=x.linewidth,T.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let W=i.properties.get(N);W.light=T}return N}function w(E,x,T,B,N,D){if(E.visible===!1)return;if(E.layers.test(N)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===Oo)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let I=e.update(E),O=E.material;if(Array.isArray(O)){let q=I.groups;for(let z=0,le=q.length;z<le;z++){let K=q[z],Q=O[K.materialIndex];if(Q&&Q.visible){let ie=A(E,Q,B,D);E.onBeforeShadow(i,E,x,T,I,ie,K),i.renderBufferDirect(T,null,I,ie,E,K),E.onAfterShadow(i,E,x,T,I,ie,K)}}}else if(O.visible){let q=A(E,O,B,D);E.onBeforeShadow(i,E,x,T,I,q,null),i.renderBufferDirect(T,null,I,q,E,null),E.onAfterShadow(i,E,x,T,I,q,null)}}let H=E.children;for(let I=0,O=H.length;I<O;I++)w(H[I],x,T,B,N,D)}function R(E){E.target.removeEventListener("dispose",R);for(let T in c){let B=c[T],N=E.target.uuid;N in B&&(B[N].dispose(),delete B[N])}}}function HE(i,e){function t(){let U=!1,re=new $t,ne=null,Ee=new $t(0,0,0,0);return{setMask:function(ve){ne!==ve&&!U&&(i.colorMask(ve,ve,ve,ve),ne=ve)},setLocked:function(ve){U=ve},setClear:function(ve,Me,He,Ke,ce){ce===!0&&(ve*=Ke,Me*=Ke,He*=Ke),re.set(ve,Me,He,Ke),Ee.equals(re)===!1&&(i.clearColor(ve,Me,He,Ke),Ee.copy(re))},reset:function(){U=!1,ne=null,Ee.set(-1,0,0,0)}}}function n(){let U=!1,re=!1,ne=null,Ee=null,ve=null;return{setReversed:function(Me){if(re!==Me){let He=e.get("EXT_clip_control");Me?He.clipControlEXT(He.LOWER_LEFT_EXT,He.ZERO_TO_ONE_EXT):He.clipControlEXT(He.LOWER_LEFT_EXT,He.NEGATIVE_ONE_TO_ONE_EXT),re=Me;let Ke=ve;ve=null,this.setClear(Ke)}},getReversed:function(){return re},setTest:function(Me){Me?_e(i.DEPTH_TEST):Ve(i.DEPTH_TEST)},setMask:function(Me){ne!==Me&&!U&&(i.depthMask(Me),ne=Me)},setFunc:function(Me){if(re&&(Me=a_[Me]),Ee!==Me){switch(Me){case Bc:i.depthFunc(i.NEVER);break;case zc:i.depthFunc(i.ALWAYS);break;case Vc:i.depthFunc(i.LESS);break;case Ro:i.depthFunc(i.LEQUAL);break;case Gc:i.depthFunc(i.EQUAL);break;case Hc:i.depthFunc(i.GEQUAL);break;case Wc:i.depthFunc(i.GREATER);break;case Xc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ee=Me}},setLocked:function(Me){U=Me},setClear:function(Me){ve!==Me&&(ve=Me,re&&(Me=1-Me),i.clearDepth(Me))},reset:function(){U=!1,ne=null,Ee=null,ve=null,re=!1}}}function s(){let U=!1,re=null,ne=null,Ee=null,ve=null,Me=null,He=null,Ke=null,ce=null;return{setTest:function(ke){U||(ke?_e(i.STENCIL_TEST):Ve(i.STENCIL_TEST))},setMask:function(ke){re!==ke&&!U&&(i.stencilMask(ke),re=ke)},setFunc:function(ke,Je,Ce){(ne!==ke||Ee!==Je||ve!==Ce)&&(i.stencilFunc(ke,Je,Ce),ne=ke,Ee=Je,ve=Ce)},setOp:function(ke,Je,Ce){(Me!==ke||He!==Je||Ke!==Ce)&&(i.stencilOp(ke,Je,Ce),Me=ke,He=Je,Ke=Ce)},setLocked:function(ke){U=ke},setClear:function(ke){ce!==ke&&(i.clearStencil(ke),ce=ke)},reset:function(){U=!1,re=null,ne=null,Ee=null,ve=null,Me=null,He=null,Ke=null,ce=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},d={},u={},p=new WeakMap,g=[],v=null,f=!1,m=null,y=null,A=null,w=null,R=null,E=null,x=null,T=new ct(0,0,0),B=0,N=!1,D=null,W=null,H=null,I=null,O=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,le=0,K=i.getParameter(i.VERSION);K.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(K)[1]),z=le>=1):K.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),z=le>=2);let Q=null,ie={},de=i.getParameter(i.SCISSOR_BOX),ue=i.getParameter(i.VIEWPORT),ee=new $t().fromArray(de),me=new $t().fromArray(ue);function ge(U,re,ne,Ee){let ve=new Uint8Array(4),Me=i.createTexture();i.bindTexture(U,Me),i.texParameteri(U,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(U,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let He=0;He<ne;He++)U===i.TEXTURE_3D||U===i.TEXTURE_2D_ARRAY?i.texImage3D(re,0,i.RGBA,1,1,Ee,0,i.RGBA,i.UNSIGNED_BYTE,ve):i.texImage2D(re+He,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ve);return Me}let xe={};xe[i.TEXTURE_2D]=ge(i.TEXTURE_2D,i.TEXTURE_2D,1),xe[i.TEXTURE_CUBE_MAP]=ge(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),xe[i.TEXTURE_2D_ARRAY]=ge(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),xe[i.TEXTURE_3D]=ge(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),_e(i.DEPTH_TEST),o.setFunc(Ro),an(!1),Dt(hf),_e(i.CULL_FACE),qt(Ir);function _e(U){h[U]!==!0&&(i.enable(U),h[U]=!0)}function Ve(U){h[U]!==!1&&(i.disable(U),h[U]=!1)}function $e(U,re){return u[U]!==re?(i.bindFramebuffer(U,re),u[U]=re,U===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=re),U===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=re),!0):!1}function Fe(U,re){let ne=g,Ee=!1;if(U){ne=p.get(re),ne===void 0&&(ne=[],p.set(re,ne));let ve=U.textures;if(ne.length!==ve.length||ne[0]!==i.COLOR_ATTACHMENT0){for(let Me=0,He=ve.length;Me<He;Me++)ne[Me]=i.COLOR_ATTACHMENT0+Me;ne.length=ve.length,Ee=!0}}else ne[0]!==i.BACK&&(ne[0]=i.BACK,Ee=!0);Ee&&i.drawBuffers(ne)}function it(U){return v!==U?(i.useProgram(U),v=U,!0):!1}let at={[Lr]:i.FUNC_ADD,[R0]:i.FUNC_SUBTRACT,[P0]:i.FUNC_REVERSE_SUBTRACT};at[I0]=i.MIN,at[L0]=i.MAX;let st={[D0]:i.ZERO,[N0]:i.ONE,[U0]:i.SRC_COLOR,[pf]:i.SRC_ALPHA,[V0]:i.SRC_ALPHA_SATURATE,[B0]:i.DST_COLOR,[O0]:i.DST_ALPHA,[F0]:i.ONE_MINUS_SRC_COLOR,[mf]:i.ONE_MINUS_SRC_ALPHA,[z0]:i.ONE_MINUS_DST_COLOR,[k0]:i.ONE_MINUS_DST_ALPHA,[G0]:i.CONSTANT_COLOR,[H0]:i.ONE_MINUS_CONSTANT_COLOR,[W0]:i.CONSTANT_ALPHA,[X0]:i.ONE_MINUS_CONSTANT_ALPHA};function qt(U,re,ne,Ee,ve,Me,He,Ke,ce,ke){if(U===Ir){f===!0&&(Ve(i.BLEND),f=!1);return}if(f===!1&&(_e(i.BLEND),f=!0),U!==C0){if(U!==m||ke!==N){if((y!==Lr||R!==Lr)&&(i.blendEquation(i.FUNC_ADD),y=Lr,R=Lr),ke)switch(U){case ko:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case uf:i.blendFunc(i.ONE,i.ONE);break;case df:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ff:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:tt("WebGLState: Invalid blending: ",U);break}else switch(U){case ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case uf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case df:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ff:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",U);break}A=null,w=null,E=null,x=null,T.set(0,0,0),B=0,m=U,N=ke}return}ve=ve||re,Me=Me||ne,He=He||Ee,(re!==y||ve!==R)&&(i.blendEquationSeparate(at[re],at[ve]),y=re,R=ve),(ne!==A||Ee!==w||Me!==E||He!==x)&&(i.blendFuncSeparate(st[ne],st[Ee],st[Me],st[He]),A=ne,w=Ee,E=Me,x=He),(Ke.equals(T)===!1||ce!==B)&&(i.blendColor(Ke.r,Ke.g,Ke.b,ce),T.copy(Ke),B=ce),m=U,N=!1}function kt(U,re){U.side===ti?Ve(i.CULL_FACE):_e(i.CULL_FACE);let ne=U.side===jn;re&&(ne=!ne),an(ne),U.blending===ko&&U.transparent===!1?qt(Ir):qt(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),r.setMask(U.colorWrite);let Ee=U.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),bt(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?_e(i.SAMPLE_ALPHA_TO_COVERAGE):Ve(i.SAMPLE_ALPHA_TO_COVERAGE)}function an(U){D!==U&&(U?i.frontFace(i.CW):i.frontFace(i.CCW),D=U)}function Dt(U){U!==E0?(_e(i.CULL_FACE),U!==W&&(U===hf?i.cullFace(i.BACK):U===T0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ve(i.CULL_FACE),W=U}function wn(U){U!==H&&(z&&i.lineWidth(U),H=U)}function bt(U,re,ne){U?(_e(i.POLYGON_OFFSET_FILL),(I!==re||O!==ne)&&(I=re,O=ne,o.getReversed()&&(re=-re,ne=-ne),i.polygonOffset(re,ne))):Ve(i.POLYGON_OFFSET_FILL)}function _n(U){U?_e(i.SCISSOR_TEST):Ve(i.SCISSOR_TEST)}function Jt(U){U===void 0&&(U=i.TEXTURE0+q-1),Q!==U&&(i.activeTexture(U),Q=U)}function ln(U,re,ne){ne===void 0&&(Q===null?ne=i.TEXTURE0+q-1:ne=Q);let Ee=ie[ne];Ee===void 0&&(Ee={type:void 0,texture:void 0},ie[ne]=Ee),(Ee.type!==U||Ee.texture!==re)&&(Q!==ne&&(i.activeTexture(ne),Q=ne),i.bindTexture(U,re||xe[U]),Ee.type=U,Ee.texture=re)}function F(){let U=ie[Q];U!==void 0&&U.type!==void 0&&(i.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Re(){try{i.compressedTexImage2D(...arguments)}catch(U){tt("WebGLState:",U)}}function Ye(){try{i.compressedTexImage3D(...arguments)}catch(U){tt("WebGLState:",U)}}function ot(){try{i.texSubImage2D(...arguments)}catch(U){tt("WebGLState:",U)}}function we(){try{i.texSubImage3D(...arguments)}catch(U){tt("WebGLState:",U)}}function Ut(){try{i.compressedTexSubImage2D(...arguments)}catch(U){tt("WebGLState:",U)}}function Ge(){try{i.compressedTexSubImage3D(...arguments)}catch(U){tt("WebGLState:",U)}}function Xe(){try{i.texStorage2D(...arguments)}catch(U){tt("WebGLState:",U)}}function C(){try{i.texStorage3D(...arguments)}catch(U){tt("WebGLState:",U)}}function b(){try{i.texImage2D(...arguments)}catch(U){tt("WebGLState:",U)}}function X(){try{i.texImage3D(...arguments)}catch(U){tt("WebGLState:",U)}}function he(U){return d[U]!==void 0?d[U]:i.getParameter(U)}function oe(U,re){d[U]!==re&&(i.pixelStorei(U,re),d[U]=re)}function ye(U){ee.equals(U)===!1&&(i.scissor(U.x,U.y,U.z,U.w),ee.copy(U))}function be(U){me.equals(U)===!1&&(i.viewport(U.x,U.y,U.z,U.w),me.copy(U))}function te(U,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Ee=ne.get(U);Ee===void 0&&(Ee=i.getUniformBlockIndex(re,U.name),i.uniformBlockBinding(re,Ee,Ee),ne.set(U,Ee))}function se(U,re,ne){let ve=c.get(re).get(U);l[ve]!==ne&&(i.bindBufferBase(i.UNIFORM_BUFFER,ve,ne),l[ve]=ne)}function pe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},Q=null,ie={},u={},l={},p=new WeakMap,g=[],v=null,f=!1,m=null,y=null,A=null,w=null,R=null,E=null,x=null,T=new ct(0,0,0),B=0,N=!1,D=null,W=null,H=null,I=null,O=null,ee.set(0,0,i.canvas.width,i.canvas.height),me.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:_e,disable:Ve,bindFramebuffer:$e,drawBuffers:Fe,useProgram:it,setBlending:qt,setMaterial:kt,setFlipSided:an,setCullFace:Dt,setLineWidth:wn,setPolygonOffset:bt,setScissorTest:_n,activeTexture:Jt,bindTexture:ln,unbindTexture:F,compressedTexImage2D:Re,compressedTexImage3D:Ye,texImage2D:b,texImage3D:X,pixelStorei:oe,getParameter:he,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:Xe,texStorage3D:C,texSubImage2D:ot,texSubImage3D:we,compressedTexSubImage2D:Ut,compressedTexSubImage3D:Ge,scissor:ye,viewport:be,reset:pe}}function WE(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new je,h=new WeakMap,d=new Set,u,p=new WeakMap,g=new Set,v=new FinalizationRegistry(C=>g.delete(C)),f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(C,b){return f?new OffscreenCanvas(C,b):Ta("canvas")}function y(C,b,X){let he=1,oe=Xe(C);if((oe.width>X||oe.height>X)&&(he=X/Math.max(oe.width,oe.height)),he<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let ye=Math.floor(he*oe.width),be=Math.floor(he*oe.height);u===void 0&&(u=m(ye,be));let te=b?m(ye,be):u;return te.width=ye,te.height=be,te.getContext("2d").drawImage(C,0,0,ye,be),qe("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ye+"x"+be+")."),te}else return"data"in C&&qe("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),C;return C}function A(C){return C.generateMipmaps}function w(C){i.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(C,b,X,he,oe,ye=!1){if(C!==null){if(i[C]!==void 0)return i[C];qe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let be;he&&(be=e.get("EXT_texture_norm16"),be||qe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=b;if(b===i.RED&&(X===i.FLOAT&&(te=i.R32F),X===i.HALF_FLOAT&&(te=i.R16F),X===i.UNSIGNED_BYTE&&(te=i.R8),X===i.UNSIGNED_SHORT&&be&&(te=be.R16_EXT),X===i.SHORT&&be&&(te=be.R16_SNORM_EXT)),b===i.RED_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.R8UI),X===i.UNSIGNED_SHORT&&(te=i.R16UI),X===i.UNSIGNED_INT&&(te=i.R32UI),X===i.BYTE&&(te=i.R8I),X===i.SHORT&&(te=i.R16I),X===i.INT&&(te=i.R32I)),b===i.RG&&(X===i.FLOAT&&(te=i.RG32F),X===i.HALF_FLOAT&&(te=i.RG16F),X===i.UNSIGNED_BYTE&&(te=i.RG8),X===i.UNSIGNED_SHORT&&be&&(te=be.RG16_EXT),X===i.SHORT&&be&&(te=be.RG16_SNORM_EXT)),b===i.RG_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RG8UI),X===i.UNSIGNED_SHORT&&(te=i.RG16UI),X===i.UNSIGNED_INT&&(te=i.RG32UI),X===i.BYTE&&(te=i.RG8I),X===i.SHORT&&(te=i.RG16I),X===i.INT&&(te=i.RG32I)),b===i.RGB_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RGB8UI),X===i.UNSIGNED_SHORT&&(te=i.RGB16UI),X===i.UNSIGNED_INT&&(te=i.RGB32UI),X===i.BYTE&&(te=i.RGB8I),X===i.SHORT&&(te=i.RGB16I),X===i.INT&&(te=i.RGB32I)),b===i.RGBA_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),X===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),X===i.UNSIGNED_INT&&(te=i.RGBA32UI),X===i.BYTE&&(te=i.RGBA8I),X===i.SHORT&&(te=i.RGBA16I),X===i.INT&&(te=i.RGBA32I)),b===i.RGB&&(X===i.UNSIGNED_SHORT&&be&&(te=be.RGB16_EXT),X===i.SHORT&&be&&(te=be.RGB16_SNORM_EXT),X===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),X===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),b===i.RGBA){let se=ye?Ea:vt.getTransfer(oe);X===i.FLOAT&&(te=i.RGBA32F),X===i.HALF_FLOAT&&(te=i.RGBA16F),X===i.UNSIGNED_BYTE&&(te=se===Ct?i.SRGB8_ALPHA8:i.RGBA8),X===i.UNSIGNED_SHORT&&be&&(te=be.RGBA16_EXT),X===i.SHORT&&be&&(te=be.RGBA16_SNORM_EXT),X===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),X===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(C,b){let X;return C?b===null||b===Hi||b===Nr?X=i.DEPTH24_STENCIL8:b===Ti?X=i.DEPTH32F_STENCIL8:b===zo&&(X=i.DEPTH24_STENCIL8,qe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===Hi||b===Nr?X=i.DEPTH_COMPONENT24:b===Ti?X=i.DEPTH_COMPONENT32F:b===zo&&(X=i.DEPTH_COMPONENT16),X}function T(C,b){return A(C)===!0||C.isFramebufferTexture&&C.minFilter!==mn&&C.minFilter!==Kn?Math.log2(Math.max(b.width,b.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?b.mipmaps.length:1}function B(C){let b=new WeakRef(C);n.get(C).__ref=b,g.add(b),v.register(C,b,b)}function N(C){let b=n.get(C).__ref;b!==void 0&&(g.delete(b),v.unregister(b))}function D(C){H(C.target)}function W(C){I(C.target)}function H(C){C.removeEventListener("dispose",D),N(C),q(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&d.delete(C)}function I(C){C.removeEventListener("dispose",W),N(C),le(C)}function O(){for(let C of g){let b=C.deref();b!==void 0&&(b.isRenderTarget===!0?I(b):H(b))}g.clear(),d.clear()}function q(C){let b=n.get(C);if(b.__webglInit===void 0)return;let X=C.source,he=p.get(X);if(he){let oe=he[b.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&z(C),Object.keys(he).length===0&&p.delete(X)}n.remove(C)}function z(C){let b=n.get(C);i.deleteTexture(b.__webglTexture);let X=C.source,he=p.get(X);delete he[b.__cacheKey],o.memory.textures--}function le(C){let b=n.get(C);b.__depthDisposeCallback&&b.__depthDisposeCallback();let X=C.depthTexture;if(X&&X.renderTarget===C&&H(X),C.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(b.__webglFramebuffer[oe]))for(let ye=0;ye<b.__webglFramebuffer[oe].length;ye++)i.deleteFramebuffer(b.__webglFramebuffer[oe][ye]);else i.deleteFramebuffer(b.__webglFramebuffer[oe]);b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer[oe])}else{if(Array.isArray(b.__webglFramebuffer))for(let oe=0;oe<b.__webglFramebuffer.length;oe++)i.deleteFramebuffer(b.__webglFramebuffer[oe]);else i.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&i.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let oe=0;oe<b.__webglColorRenderbuffer.length;oe++)b.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(b.__webglColorRenderbuffer[oe]);b.__webglDepthRenderbuffer&&i.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let he=C.textures;for(let oe=0,ye=he.length;oe<ye;oe++){let be=n.get(he[oe]);be.__webglTexture&&(i.deleteTexture(be.__webglTexture),o.memory.textures--),n.remove(he[oe])}n.remove(C)}let K=0;function Q(){K=0}function ie(){return K}function de(C){K=C}function ue(){let C=K;return C>=s.maxTextures&&qe("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,C}function ee(C){let b=[];return b.push(C.wrapS),b.push(C.wrapT),b.push(C.wrapR||0),b.push(C.magFilter),b.push(C.minFilter),b.push(C.anisotropy),b.push(C.internalFormat),b.push(C.format),b.push(C.type),b.push(C.generateMipmaps),b.push(C.mipmapsAutoUpdate),b.push(C.premultiplyAlpha),b.push(C.flipY),b.push(C.unpackAlignment),b.push(C.colorSpace),b.join()}function me(C,b){let X=n.get(C);if(C.isVideoTexture&&Ut(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&X.__version!==C.version){let he=C.image;if(he===null)qe("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)qe("WebGLRenderer: Texture marked for update but image is incomplete");else{kt(X,C,b);return}}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,X.__webglTexture,i.TEXTURE0+b)}function ge(C,b){let X=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){kt(X,C,b);return}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,X.__webglTexture,i.TEXTURE0+b)}function xe(C,b){let X=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){kt(X,C,b);return}t.bindTexture(i.TEXTURE_3D,X.__webglTexture,i.TEXTURE0+b)}function _e(C,b){let X=n.get(C);if(C.version>0&&X.__version!==C.version){an(X,C,b);return}t.bindTexture(i.TEXTURE_CUBE_MAP,X.__webglTexture,i.TEXTURE0+b)}let Ve={[qc]:i.REPEAT,[is]:i.CLAMP_TO_EDGE,[Yc]:i.MIRRORED_REPEAT},$e={[mn]:i.NEAREST,[$0]:i.NEAREST_MIPMAP_NEAREST,[$a]:i.NEAREST_MIPMAP_LINEAR,[Kn]:i.LINEAR,[yh]:i.LINEAR_MIPMAP_NEAREST,[Ls]:i.LINEAR_MIPMAP_LINEAR},Fe={[j0]:i.NEVER,[Lf]:i.ALWAYS,[Q0]:i.LESS,[Pf]:i.LEQUAL,[e_]:i.EQUAL,[If]:i.GEQUAL,[t_]:i.GREATER,[n_]:i.NOTEQUAL};function it(C,b){if(b.type===Ti&&e.has("OES_texture_float_linear")===!1&&(b.magFilter===Kn||b.magFilter===yh||b.magFilter===$a||b.magFilter===Ls||b.minFilter===Kn||b.minFilter===yh||b.minFilter===$a||b.minFilter===Ls)&&qe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,Ve[b.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,Ve[b.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,Ve[b.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,$e[b.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,$e[b.minFilter]),b.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,Fe[b.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===mn||b.minFilter!==$a&&b.minFilter!==Ls||b.type===Ti&&e.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||n.get(b).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),n.get(b).__currentAnisotropy=b.anisotropy}}}function at(C,b){let X=!1;C.__webglInit===void 0&&(C.__webglInit=!0,b.addEventListener("dispose",D),B(b));let he=b.source,oe=p.get(he);oe===void 0&&(oe={},p.set(he,oe));let ye=ee(b);if(ye!==C.__cacheKey){oe[ye]===void 0&&(oe[ye]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,X=!0),oe[ye].usedTimes++;let be=oe[C.__cacheKey];be!==void 0&&(oe[C.__cacheKey].usedTimes--,be.usedTimes===0&&z(b)),C.__cacheKey=ye,C.__webglTexture=oe[ye].texture}return X}function st(C,b,X){return Math.floor(Math.floor(C/X)/b)}function qt(C,b,X,he){let ye=C.updateRanges;if(ye.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,b.width,b.height,X,he,b.data);else{ye.sort((U,re)=>U.start-re.start);let be=0;for(let U=1;U<ye.length;U++){let re=ye[be],ne=ye[U],Ee=re.start+re.count,ve=st(ne.start,b.width,4),Me=st(re.start,b.width,4);ne.start<=Ee+1&&ve===Me&&st(ne.start+ne.count-1,b.width,4)===ve?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++be,ye[be]=ne)}ye.length=be+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),pe=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,b.width);for(let U=0,re=ye.length;U<re;U++){let ne=ye[U],Ee=Math.floor(ne.start/4),ve=Math.ceil(ne.count/4),Me=Ee%b.width,He=Math.floor(Ee/b.width),Ke=ve,ce=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(i.UNPACK_SKIP_ROWS,He),t.texSubImage2D(i.TEXTURE_2D,0,Me,He,Ke,ce,X,he,b.data)}C.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,pe)}}function kt(C,b,X){let he=i.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(he=i.TEXTURE_2D_ARRAY),b.isData3DTexture&&(he=i.TEXTURE_3D);let oe=at(C,b),ye=b.source;t.bindTexture(he,C.__webglTexture,i.TEXTURE0+X);let be=n.get(ye);if(ye.version!==be.__version||oe===!0){if(t.activeTexture(i.TEXTURE0+X),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let ce=vt.getPrimaries(vt.workingColorSpace),ke=b.colorSpace===Ns?null:vt.getPrimaries(b.colorSpace),Je=b.colorSpace===Ns||ce===ke?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Je)}t.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment);let se=y(b.image,!1,s.maxTextureSize);se=Ge(b,se);let pe=r.convert(b.format,b.colorSpace),U=r.convert(b.type),re=E(b.internalFormat,pe,U,b.normalized,b.colorSpace,b.isVideoTexture);it(he,b);let ne,Ee=b.mipmaps,ve=b.isVideoTexture!==!0,Me=be.__version===void 0||oe===!0,He=ye.dataReady,Ke=T(b,se);if(b.isDepthTexture)re=x(b.format===Ds,b.type),Me&&(ve?t.texStorage2D(i.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,pe,U,null));else if(b.isDataTexture)if(Ee.length>0){ve&&Me&&t.texStorage2D(i.TEXTURE_2D,Ke,re,Ee[0].width,Ee[0].height);for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],ve?He&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,U,ne.data):t.texImage2D(i.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,U,ne.data);b.generateMipmaps=!1}else ve?(Me&&t.texStorage2D(i.TEXTURE_2D,Ke,re,se.width,se.height),He&&qt(b,se,pe,U)):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,pe,U,se.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){ve&&Me&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ke,re,Ee[0].width,Ee[0].height,se.depth);for(let ce=0,ke=Ee.length;ce<ke;ce++)if(ne=Ee[ce],b.format!==Xi)if(pe!==null)if(ve){if(He)if(b.layerUpdates.size>0){let Je=Gf(ne.width,ne.height,b.format,b.type);for(let Ce of b.layerUpdates){let lt=ne.data.subarray(Ce*Je/ne.data.BYTES_PER_ELEMENT,(Ce+1)*Je/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,pe,lt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ve?He&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,U,ne.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,pe,U,ne.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{ve&&Me&&t.texStorage2D(i.TEXTURE_2D,Ke,re,Ee[0].width,Ee[0].height);for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],b.format!==Xi?pe!==null?ve?He&&t.compressedTexSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(i.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ve?He&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,U,ne.data):t.texImage2D(i.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,U,ne.data)}else if(b.isDataArrayTexture)if(ve){if(Me&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ke,re,se.width,se.height,se.depth),He)if(b.layerUpdates.size>0){let ce=Gf(se.width,se.height,b.format,b.type);for(let ke of b.layerUpdates){let Je=se.data.subarray(ke*ce/se.data.BYTES_PER_ELEMENT,(ke+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ke,se.width,se.height,1,pe,U,Je)}b.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,U,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,U,se.data);else if(b.isData3DTexture)ve?(Me&&t.texStorage3D(i.TEXTURE_3D,Ke,re,se.width,se.height,se.depth),He&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,U,se.data)):t.texImage3D(i.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,U,se.data);else if(b.isFramebufferTexture){if(Me)if(ve)t.texStorage2D(i.TEXTURE_2D,Ke,re,se.width,se.height);else{let ce=se.width,ke=se.height;for(let Je=0;Je<Ke;Je++)t.texImage2D(i.TEXTURE_2D,Je,re,ce,ke,0,pe,U,null),ce>>=1,ke>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in i){let ce=i.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),d.add(b),ce.onpaint=ke=>{let Je=ke.changedElements;for(let Ce of d)Je.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let Je=i.RGBA,Ce=i.RGBA,lt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Je,Ce,lt,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(ve&&Me){let ce=Xe(Ee[0]);t.texStorage2D(i.TEXTURE_2D,Ke,re,ce.width,ce.height)}for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],ve?He&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,pe,U,ne):t.texImage2D(i.TEXTURE_2D,ce,re,pe,U,ne);b.generateMipmaps=!1}else if(ve){if(Me){let ce=Xe(se);t.texStorage2D(i.TEXTURE_2D,Ke,re,ce.width,ce.height)}He&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe,U,se)}else t.texImage2D(i.TEXTURE_2D,0,re,pe,U,se);A(b)&&b.mipmapsAutoUpdate===!0&&w(he),be.__version=ye.version,b.onUpdate&&b.onUpdate(b)}C.__version=b.version}function an(C,b,X){if(b.image.length!==6)return;let he=at(C,b),oe=b.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+X);let ye=n.get(oe);if(oe.version!==ye.__version||he===!0){t.activeTexture(i.TEXTURE0+X);let be=vt.getPrimaries(vt.workingColorSpace),te=b.colorSpace===Ns?null:vt.getPrimaries(b.colorSpace),se=b.colorSpace===Ns||be===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=b.isCompressedTexture||b.image[0].isCompressedTexture,U=b.image[0]&&b.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!U?re[Ce]=y(b.image[Ce],!0,s.maxCubemapSize):re[Ce]=U?b.image[Ce].image:b.image[Ce],re[Ce]=Ge(b,re[Ce]);let ne=re[0],Ee=r.convert(b.format,b.colorSpace),ve=r.convert(b.type),Me=E(b.internalFormat,Ee,ve,b.normalized,b.colorSpace),He=b.isVideoTexture!==!0,Ke=ye.__version===void 0||he===!0,ce=oe.dataReady,ke=T(b,ne);it(i.TEXTURE_CUBE_MAP,b);let Je;if(b.isDepthTexture){if(Me=x(b.format===Ds,b.type),Ke)if(He)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Me,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,ne.width,ne.height,0,Ee,ve,null)}else if(pe){He&&Ke&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ke,Me,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){Je=re[Ce].mipmaps;for(let lt=0;lt<Je.length;lt++){let Bt=Je[lt];b.format!==Xi?Ee!==null?He?ce&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Bt.width,Bt.height,Ee,Bt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,Me,Bt.width,Bt.height,0,Bt.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):He?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Bt.width,Bt.height,Ee,ve,Bt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,Me,Bt.width,Bt.height,0,Ee,ve,Bt.data)}}}else{if(Je=b.mipmaps,He&&Ke){Je.length>0&&ke++;let Ce=Xe(re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ke,Me,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(U){He?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,Ee,ve,re[Ce].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,re[Ce].width,re[Ce].height,0,Ee,ve,re[Ce].data);for(let lt=0;lt<Je.length;lt++){let Vn=Je[lt].image[Ce].image;He?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,Vn.width,Vn.height,Ee,ve,Vn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,Me,Vn.width,Vn.height,0,Ee,ve,Vn.data)}}else{He?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Ee,ve,re[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,Ee,ve,re[Ce]);for(let lt=0;lt<Je.length;lt++){let Bt=Je[lt];He?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,Ee,ve,Bt.image[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,Me,Ee,ve,Bt.image[Ce])}}}A(b)&&b.mipmapsAutoUpdate===!0&&w(i.TEXTURE_CUBE_MAP),ye.__version=oe.version,b.onUpdate&&b.onUpdate(b)}C.__version=b.version}function Dt(C,b,X,he,oe,ye){let be=r.convert(X.format,X.colorSpace),te=r.convert(X.type),se=E(X.internalFormat,be,te,X.normalized,X.colorSpace),pe=n.get(b),U=n.get(X);if(U.__renderTarget=b,!pe.__hasExternalTextures){let re=Math.max(1,b.width>>ye),ne=Math.max(1,b.height>>ye);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,ye,se,re,ne,b.depth,0,be,te,null):t.texImage2D(oe,ye,se,re,ne,0,be,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),we(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,he,oe,U.__webglTexture,0,ot(b)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,he,oe,U.__webglTexture,ye),t.bindFramebuffer(i.FRAMEBUFFER,null)}function wn(C,b,X){if(i.bindRenderbuffer(i.RENDERBUFFER,C),b.depthBuffer){let he=b.depthTexture,oe=he&&he.isDepthTexture?he.type:null,ye=x(b.stencilBuffer,oe),be=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;we(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ot(b),ye,b.width,b.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,ot(b),ye,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,ye,b.width,b.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,be,i.RENDERBUFFER,C)}else{let he=b.textures;for(let oe=0;oe<he.length;oe++){let ye=he[oe],be=r.convert(ye.format,ye.colorSpace),te=r.convert(ye.type),se=E(ye.internalFormat,be,te,ye.normalized,ye.colorSpace);we(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ot(b),se,b.width,b.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,ot(b),se,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,se,b.width,b.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function bt(C,b,X){let he=b.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(b.depthTexture);oe.__renderTarget=b;let ye=he?b.depthTexture.image[0]:b.depthTexture.image;(!oe.__webglTexture||ye.width!==b.width||ye.height!==b.height)&&(ye.width=b.width,ye.height=b.height,b.depthTexture.needsUpdate=!0),he?_e(b.depthTexture,0):me(b.depthTexture,0);let be=oe.__webglTexture,te=ot(b),se=he?i.TEXTURE_CUBE_MAP_POSITIVE_X+X:i.TEXTURE_2D,pe=b.depthTexture.format===Ds?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(b.depthTexture.format===As)we(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,se,be,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,pe,se,be,0);else if(b.depthTexture.format===Ds)we(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,se,be,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,pe,se,be,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function _n(C){let b=n.get(C),X=C.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==C.depthTexture){let he=C.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),he){let oe=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,he.removeEventListener("dispose",oe)};he.addEventListener("dispose",oe),b.__depthDisposeCallback=oe}b.__boundDepthTexture=he}if(C.depthTexture&&!b.__autoAllocateDepthBuffer)if(X)for(let he=0;he<6;he++)bt(b.__webglFramebuffer[he],C,he);else C.texture.mipmaps.length>0?bt(b.__webglFramebuffer[0],C,0):bt(b.__webglFramebuffer,C,0);else if(X){b.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[he]),b.__webglDepthbuffer[he]===void 0)b.__webglDepthbuffer[he]=i.createRenderbuffer(),wn(b.__webglDepthbuffer[he],C,!1);else{let oe=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=b.__webglDepthbuffer[he];i.bindRenderbuffer(i.RENDERBUFFER,ye),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ye)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=i.createRenderbuffer(),wn(b.__webglDepthbuffer,C,!1);else{let oe=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=b.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ye),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ye)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Jt(C,b,X){let he=n.get(C);b!==void 0&&Dt(he.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),X!==void 0&&_n(C)}function ln(C){let b=C.texture,X=n.get(C),he=n.get(b);C.addEventListener("dispose",W),B(C);let oe=C.textures,ye=C.isWebGLCubeRenderTarget===!0,be=oe.length>1;if(be||(he.__webglTexture===void 0&&(he.__webglTexture=i.createTexture()),he.__version=b.version,o.memory.textures++),ye){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(b.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let se=0;se<b.mipmaps.length;se++)X.__webglFramebuffer[te][se]=i.createFramebuffer()}else X.__webglFramebuffer[te]=i.createFramebuffer()}else{if(b.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<b.mipmaps.length;te++)X.__webglFramebuffer[te]=i.createFramebuffer()}else X.__webglFramebuffer=i.createFramebuffer();if(be)for(let te=0,se=oe.length;te<se;te++){let pe=n.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&we(C)===!1){X.__webglMultisampledFramebuffer=i.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];X.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),U=r.convert(se.type),re=E(se.internalFormat,pe,U,se.normalized,se.colorSpace,C.isXRRenderTarget===!0),ne=ot(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,ne,re,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,X.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(X.__webglDepthRenderbuffer=i.createRenderbuffer(),wn(X.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ye){t.bindTexture(i.TEXTURE_CUBE_MAP,he.__webglTexture),it(i.TEXTURE_CUBE_MAP,b);for(let te=0;te<6;te++)if(b.mipmaps.length>0)for(let se=0;se<b.mipmaps.length;se++)Dt(X.__webglFramebuffer[te][se],C,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Dt(X.__webglFramebuffer[te],C,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);A(b)?w(i.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}else if(be){for(let te=0,se=oe.length;te<se;te++){let pe=oe[te],U=n.get(pe),re=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(re=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(re,U.__webglTexture),it(re,pe),Dt(X.__webglFramebuffer,C,pe,i.COLOR_ATTACHMENT0+te,re,0),A(pe)&&w(re)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(te=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,he.__webglTexture),it(te,b),b.mipmaps.length>0)for(let se=0;se<b.mipmaps.length;se++)Dt(X.__webglFramebuffer[se],C,b,i.COLOR_ATTACHMENT0,te,se);else Dt(X.__webglFramebuffer,C,b,i.COLOR_ATTACHMENT0,te,0);A(b)?w(te):b.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&_n(C)}function F(C){let b=C.textures;for(let X=0,he=b.length;X<he;X++){let oe=b[X];if(A(oe)&&oe.mipmapsAutoUpdate===!0){let ye=R(C),be=n.get(oe).__webglTexture;t.bindTexture(ye,be),w(ye),t.unbindTexture()}}}let Re=[];function Ye(C){if(C.samples>0){if(we(C)===!1){let b=C.textures,X=C.width,he=C.height,oe=i.COLOR_BUFFER_BIT,ye=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=n.get(C),te=b.length>1;if(te)for(let pe=0;pe<b.length;pe++)t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let pe=0;pe<b.length;pe++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,be.__webglColorRenderbuffer[pe]);let U=n.get(b[pe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,U,0)}i.blitFramebuffer(0,0,X,he,0,0,X,he,oe,i.NEAREST),l===!0&&(Re.length=0,Re.push(i.COLOR_ATTACHMENT0+pe),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Re.push(ye),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<b.length;pe++){t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,be.__webglColorRenderbuffer[pe]);let U=n.get(b[pe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,U,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let b=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[b])}}}function ot(C){return Math.min(s.maxSamples,C.samples)}function we(C){let b=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Ut(C){let b=o.render.frame;h.get(C)!==b&&(h.set(C,b),C.update())}function Ge(C,b){let X=C.colorSpace,he=C.format,oe=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||X!==wa&&X!==Ns&&(vt.getTransfer(X)===Ct?(he!==Xi||oe!==ni)&&qe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",X)),b}function Xe(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=xe,this.setTextureCube=_e,this.rebindTextures=Jt,this.setupRenderTarget=ln,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=Ye,this.setupDepthRenderbuffer=_n,this.setupFrameBufferTexture=Dt,this.useMultisampledRTT=we,this.dispose=O}function XE(i,e){function t(n,s=Ns){let r,o=vt.getTransfer(s);if(n===ni)return i.UNSIGNED_BYTE;if(n===Sh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Mh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Tf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Af)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===wf)return i.BYTE;if(n===Ef)return i.SHORT;if(n===zo)return i.UNSIGNED_SHORT;if(n===bh)return i.INT;if(n===Hi)return i.UNSIGNED_INT;if(n===Ti)return i.FLOAT;if(n===Wi)return i.HALF_FLOAT;if(n===Cf)return i.ALPHA;if(n===Rf)return i.RGB;if(n===Xi)return i.RGBA;if(n===As)return i.DEPTH_COMPONENT;if(n===Ds)return i.DEPTH_STENCIL;if(n===wh)return i.RED;if(n===Eh)return i.RED_INTEGER;if(n===lr)return i.RG;if(n===Th)return i.RG_INTEGER;if(n===Ah)return i.RGBA_INTEGER;if(n===Za||n===Ka||n===Ja||n===ja)if(o===Ct)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Za)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ka)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ja)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ja)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Za)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ka)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ja)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ja)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Ch||n===Rh||n===Ph||n===Ih)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Ch)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Rh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Ph)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Ih)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Lh||n===Dh||n===Nh||n===Uh||n===Fh||n===Qa||n===Oh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Lh||n===Dh)return o===Ct?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Nh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Uh)return r.COMPRESSED_R11_EAC;if(n===Fh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Qa)return r.COMPRESSED_RG11_EAC;if(n===Oh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===kh||n===Bh||n===zh||n===Vh||n===Gh||n===Hh||n===Wh||n===Xh||n===qh||n===Yh||n===$h||n===Zh||n===Kh||n===Jh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===kh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Bh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===zh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Vh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Gh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Hh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Wh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Xh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===qh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Yh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===$h)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Zh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Kh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Jh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===jh||n===Qh||n===eu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===jh)return o===Ct?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Qh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===eu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===tu||n===nu||n===el||n===iu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===tu)return r.COMPRESSED_RED_RGTC1_EXT;if(n===nu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===el)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===iu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Nr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var qE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,YE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,np=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ba(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new os({vertexShader:qE,fragmentShader:YE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Kt(new rs(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ip=class extends zi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,p=null,g=null,v=typeof XRWebGLBinding<"u",f=new np,m={},y=t.getContextAttributes(),A=null,w=null,R=[],E=[],x=new je,T=null,B=null,N=new Zn;N.viewport=new $t;let D=new Zn;D.viewport=new $t;let W=[N,D],H=new mh,I=null,O=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=R[ee];return me===void 0&&(me=new No,R[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=R[ee];return me===void 0&&(me=new No,R[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=R[ee];return me===void 0&&(me=new No,R[ee]=me),me.getHandSpace()};function q(ee){let me=E.indexOf(ee.inputSource);if(me===-1)return;let ge=R[me];ge!==void 0&&(ge.update(ee.inputSource,ee.frame,c||o),ge.dispatchEvent({type:ee.type,data:ee.inputSource}))}function z(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<R.length;ee++){let me=E[ee];me!==null&&(E[ee]=null,R[ee].disconnect(me))}I=null,O=null,f.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(A),p=null,u=null,d=null,s=null,w=null,ue.stop(),n.isPresenting=!1,e.setPixelRatio(T),e.setSize(x.width,x.height,!1),B!==null){let ee=B.camera;ee.fov=B.fov,ee.zoom=B.zoom,ee.updateProjectionMatrix(),B=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&qe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&qe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return u!==null?u:p},this.getBinding=function(){return d===null&&v&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",z),s.addEventListener("inputsourceschange",le),y.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(x),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,xe=null,_e=null;y.depth&&(_e=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=y.stencil?Ds:As,xe=y.stencil?Nr:Hi);let Ve={colorFormat:t.RGBA8,depthFormat:_e,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Ve),s.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),w=new mi(u.textureWidth,u.textureHeight,{format:Xi,type:ni,depthTexture:new Is(u.textureWidth,u.textureHeight,xe,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let ge={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),w=new mi(p.framebufferWidth,p.framebufferHeight,{format:Xi,type:ni,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return f.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ge=ee.removed[me],xe=E.indexOf(ge);xe>=0&&(E[xe]=null,R[xe].disconnect(ge))}for(let me=0;me<ee.added.length;me++){let ge=ee.added[me],xe=E.indexOf(ge);if(xe===-1){for(let Ve=0;Ve<R.length;Ve++)if(Ve>=E.length){E.push(ge),xe=Ve;break}else if(E[Ve]===null){E[Ve]=ge,xe=Ve;break}if(xe===-1)break}let _e=R[xe];_e&&_e.connect(ge)}}function K(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ge=ee.far;f.texture!==null&&(f.depthNear>0&&(me=f.depthNear),f.depthFar>0&&(ge=f.depthFar)),H.near=D.near=N.near=me,H.far=D.far=N.far=ge,(I!==H.near||O!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),I=H.near,O=H.far),H.layers.mask=ee.layers.mask|6,N.layers.mask=H.layers.mask&-5,D.layers.mask=H.layers.mask&-3;let xe=ee.parent,_e=H.cameras;K(H,xe);for(let Ve=0;Ve<_e.length;Ve++)K(_e[Ve],xe);H.projectionMatrix.copy(N.projectionMatrix),H.projectionMatrixInverse.copy(N.projectionMatrixInverse),B===null&&ee.isPerspectiveCamera&&(B={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,H,xe)};function Q(ee,me,ge){ge===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ge.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Lo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(u===null&&p===null))return l},this.setFoveation=function(ee){l=ee,u!==null&&(u.fixedFoveation=ee),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=ee)},this.hasDepthSensing=function(){return f.texture!==null},this.getDepthSensingMesh=function(){return f.getMesh(H)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function de(ee,me){if(h=me.getViewerPose(c||o),g=me,h!==null){let ge=h.views;p!==null&&(e.setRenderTargetFramebuffer(w,p.framebuffer),e.setRenderTarget(w));let xe=!1;ge.length!==H.cameras.length&&(H.cameras.length=0,xe=!0);for(let Fe=0;Fe<ge.length;Fe++){let it=ge[Fe],at=null;if(p!==null)at=p.getViewport(it);else{let qt=d.getViewSubImage(u,it);at=qt.viewport,Fe===0&&(e.setRenderTargetTextures(w,qt.colorTexture,qt.depthStencilTexture),e.setRenderTarget(w))}let st=W[Fe];st===void 0&&(st=new Zn,st.layers.enable(Fe),st.viewport=new $t,W[Fe]=st),st.matrix.fromArray(it.transform.matrix),st.matrix.decompose(st.position,st.quaternion,st.scale),st.projectionMatrix.fromArray(it.projectionMatrix),st.projectionMatrixInverse.copy(st.projectionMatrix).invert(),st.viewport.set(at.x,at.y,at.width,at.height),Fe===0&&(H.matrix.copy(st.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),xe===!0&&H.cameras.push(st)}let _e=s.enabledFeatures;if(_e&&_e.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){d=n.getBinding();let Fe=d.getDepthInformation(ge[0]);Fe&&Fe.isValid&&Fe.texture&&f.init(Fe,s.renderState)}if(_e&&_e.includes("camera-access")&&v){e.state.unbindTexture(),d=n.getBinding();for(let Fe=0;Fe<ge.length;Fe++){let it=ge[Fe].camera;if(it){let at=m[it];at||(at=new Ba,m[it]=at);let st=d.getCameraImage(it);at.sourceTexture=st}}}}for(let ge=0;ge<R.length;ge++){let xe=E[ge],_e=R[ge];xe!==null&&_e!==void 0&&_e.update(xe,me,c||o)}ie&&ie(ee,me),me.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:me}),g=null}let ue=new U_;ue.setAnimationLoop(de),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},$E=new Rt,X_=new nt;X_.set(-1,0,0,0,1,0,0,0,1);function ZE(i,e){function t(f,m){f.matrixAutoUpdate===!0&&f.updateMatrix(),m.value.copy(f.matrix)}function n(f,m){m.color.getRGB(f.fogColor.value,Bf(i)),m.isFog?(f.fogNear.value=m.near,f.fogFar.value=m.far):m.isFogExp2&&(f.fogDensity.value=m.density)}function s(f,m,y,A,w){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(f,m):m.isMeshLambertMaterial?(r(f,m),m.envMap&&(f.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(f,m),d(f,m)):m.isMeshPhongMaterial?(r(f,m),h(f,m),m.envMap&&(f.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(f,m),u(f,m),m.isMeshPhysicalMaterial&&p(f,m,w)):m.isMeshMatcapMaterial?(r(f,m),g(f,m)):m.isMeshDepthMaterial?r(f,m):m.isMeshDistanceMaterial?(r(f,m),v(f,m)):m.isMeshNormalMaterial?r(f,m):m.isLineBasicMaterial?(o(f,m),m.isLineDashedMaterial&&a(f,m)):m.isPointsMaterial?l(f,m,y,A):m.isSpriteMaterial?c(f,m):m.isShadowMaterial?(f.color.value.copy(m.color),f.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(f,m){f.opacity.value=m.opacity,m.color&&f.diffuse.value.copy(m.color),m.emissive&&f.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(f.map.value=m.map,t(m.map,f.mapTransform)),m.alphaMap&&(f.alphaMap.value=m.alphaMap,t(m.alphaMap,f.alphaMapTransform)),m.bumpMap&&(f.bumpMap.value=m.bumpMap,t(m.bumpMap,f.bumpMapTransform),f.bumpScale.value=m.bumpScale,m.side===jn&&(f.bumpScale.value*=-1)),m.normalMap&&(f.normalMap.value=m.normalMap,t(m.normalMap,f.normalMapTransform),f.normalScale.value.copy(m.normalScale),m.side===jn&&f.normalScale.value.negate()),m.displacementMap&&(f.displacementMap.value=m.displacementMap,t(m.displacementMap,f.displacementMapTransform),f.displacementScale.value=m.displacementScale,f.displacementBias.value=m.displacementBias),m.emissiveMap&&(f.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,f.emissiveMapTransform)),m.specularMap&&(f.specularMap.value=m.specularMap,t(m.specularMap,f.specularMapTransform)),m.alphaTest>0&&(f.alphaTest.value=m.alphaTest);let y=e.get(m),A=y.envMap,w=y.envMapRotation;A&&(f.envMap.value=A,f.envMapRotation.value.setFromMatrix4($E.makeRotationFromEuler(w)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&f.envMapRotation.value.premultiply(X_),f.reflectivity.value=m.reflectivity,f.ior.value=m.ior,f.refractionRatio.value=m.refractionRatio),m.lightMap&&(f.lightMap.value=m.lightMap,f.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,f.lightMapTransform)),m.aoMap&&(f.aoMap.value=m.aoMap,f.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,f.aoMapTransform))}function o(f,m){f.diffuse.value.copy(m.color),f.opacity.value=m.opacity,m.map&&(f.map.value=m.map,t(m.map,f.mapTransform))}function a(f,m){f.dashSize.value=m.dashSize,f.totalSize.value=m.dashSize+m.gapSize,f.scale.value=m.scale}function l(f,m,y,A){f.diffuse.value.copy(m.color),f.opacity.value=m.opacity,f.size.value=m.size*y,f.scale.value=A*.5,m.map&&(f.map.value=m.map,t(m.map,f.uvTransform)),m.alphaMap&&(f.alphaMap.value=m.alphaMap,t(m.alphaMap,f.alphaMapTransform)),m.alphaTest>0&&(f.alphaTest.value=m.alphaTest)}function c(f,m){f.diffuse.value.copy(m.color),f.opacity.value=m.opacity,f.rotation.value=m.rotation,m.map&&(f.map.value=m.map,t(m.map,f.mapTransform)),m.alphaMap&&(f.alphaMap.value=m.alphaMap,t(m.alphaMap,f.alphaMapTransform)),m.alphaTest>0&&(f.alphaTest.value=m.alphaTest)}function h(f,m){f.specular.value.copy(m.specular),f.shininess.value=Math.max(m.shininess,1e-4)}function d(f,m){m.gradientMap&&(f.gradientMap.value=m.gradientMap)}function u(f,m){f.metalness.value=m.metalness,m.metalnessMap&&(f.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,f.metalnessMapTransform)),f.roughness.value=m.roughness,m.roughnessMap&&(f.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,f.roughnessMapTransform)),m.envMap&&(f.envMapIntensity.value=m.envMapIntensity)}function p(f,m,y){f.ior.value=m.ior,m.diffuseRoughness>0&&(f.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(f.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,f.diffuseRoughnessMapTransform))),m.sheen>0&&(f.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),f.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(f.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,f.sheenColorMapTransform)),m.sheenRoughnessMap&&(f.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,f.sheenRoughnessMapTransform))),m.clearcoat>0&&(f.clearcoat.value=m.clearcoat,f.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(f.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,f.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(f.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,f.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(f.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,f.clearcoatNormalMapTransform),f.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===jn&&f.clearcoatNormalScale.value.negate())),m.dispersion>0&&(f.dispersion.value=m.dispersion),m.retroreflectivity>0&&(f.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(f.iridescence.value=m.iridescence,f.iridescenceIOR.value=m.iridescenceIOR,f.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,f.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(f.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,f.iridescenceMapTransform)),m.iridescenceThicknessMap&&(f.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,f.iridescenceThicknessMapTransform))),m.transmission>0&&(f.transmission.value=m.transmission,f.transmissionSamplerMap.value=y.texture,f.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(f.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,f.transmissionMapTransform)),f.thickness.value=m.thickness,m.thicknessMap&&(f.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,f.thicknessMapTransform)),f.attenuationDistance.value=m.attenuationDistance,f.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(f.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(f.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,f.anisotropyMapTransform))),f.specularIntensity.value=m.specularIntensity,f.specularColor.value.copy(m.specularColor),m.specularColorMap&&(f.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,f.specularColorMapTransform)),m.specularIntensityMap&&(f.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,f.specularIntensityMapTransform))}function g(f,m){m.matcap&&(f.matcap.value=m.matcap)}function v(f,m){let y=e.get(m).light;f.referencePosition.value.setFromMatrixPosition(y.matrixWorld),f.nearDistance.value=y.shadow.camera.near,f.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function KE(i,e,t,n){let s={},r={};function o(y,A){let w=A.program;n.uniformBlockBinding(y,w,s[y.id])}function a(y,A){let w=s[y.id];w===void 0&&(g(y),w=l(y),s[y.id]=w,y.addEventListener("dispose",f));let R=A.program;n.updateUBOMapping(y,R);let E=e.render.frame;r[y.id]!==E&&(c(y),r[y.id]=E)}function l(y){let A=i.createBuffer(),w=y.__size,R=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,w,R),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function c(y){let A=s[y.id],w=y.uniforms,R=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,x=w.length;E<x;E++){let T=w[E];if(Array.isArray(T))for(let B=0,N=T.length;B<N;B++)h(T[B],E,B,R);else h(T,E,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,A,w,R){if(u(y,A,w,R)===!0){let E=y.__offset,x=y.value;if(Array.isArray(x)){let T=0;for(let B=0;B<x.length;B++){let N=x[B],D=v(N,!0);d(N,y.__data,T),T+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else d(x,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,y.__data)}}function d(y,A,w){typeof y=="number"||typeof y=="boolean"?A[w]=y:y.isMatrix3?(A[w]=y.elements[0],A[w+1]=y.elements[1],A[w+2]=y.elements[2],A[w+3]=0,A[w+4]=y.elements[3],A[w+5]=y.elements[4],A[w+6]=y.elements[5],A[w+7]=0,A[w+8]=y.elements[6],A[w+9]=y.elements[7],A[w+10]=y.elements[8],A[w+11]=0):ArrayBuffer.isView(y)?A.set(y.subarray(0,A.length-w),w):y.toArray(A,w)}function u(y,A,w,R){let E=y.value,x=A+"_"+w;if(Array.isArray(E)){R[x]===void 0&&(R[x]=[]);let T=R[x],B=!1;for(let N=0;N<E.length;N++)p(E[N],T,N)===!0&&(B=!0);return B}return p(E,R,x)}function p(y,A,w){if(A[w]===void 0)return typeof y=="number"||typeof y=="boolean"?A[w]=y:ArrayBuffer.isView(y)?A[w]=y.slice():A[w]=y.clone(),!0;{let R=A[w];if(typeof y=="number"||typeof y=="boolean"){if(R!==y)return A[w]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(R.equals(y)===!1)return R.copy(y),!0}}return!1}function g(y){let A=y.uniforms,w=0,R=16;for(let x=0,T=A.length;x<T;x++){let B=Array.isArray(A[x])?A[x]:[A[x]];for(let N=0,D=B.length;N<D;N++){let W=B[N],H=Array.isArray(W.value)?W.value:[W.value],I=Array.isArray(A[x])||Array.isArray(W.value),O=w;for(let z=0,le=H.length;z<le;z++){let K=H[z],Q=v(K,I),ie=w%R,de=ie%Q.boundary,ue=ie+de;w+=de,ue!==0&&R-ue<Q.storage&&(w+=R-ue),z===0&&(O=w),w+=Q.storage}let q=W.type==="int"?Int32Array:W.type==="uint"?Uint32Array:Float32Array;W.__data=new q((w-O)/Float32Array.BYTES_PER_ELEMENT),W.__offset=O}}let E=w%R;return E>0&&(w+=R-E),y.__size=w,y.__cache={},this}function v(y,A){let w={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(w.boundary=4,w.storage=4):y.isVector2?(w.boundary=8,w.storage=8):y.isVector3||y.isColor?(w.boundary=16,w.storage=12):y.isVector4?(w.boundary=16,w.storage=16):y.isMatrix3?(w.boundary=16,w.storage=48):y.isMatrix4?(w.boundary=16,w.storage=64):y.isTexture?qe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(w.boundary=16,w.storage=y.byteLength):qe("WebGLRenderer: Unsupported uniform value type.",y),A===!0&&(w.boundary=16,w.storage=Math.ceil(w.storage/16)*16),w}function f(y){let A=y.target;A.removeEventListener("dispose",f),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:m}}var JE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ls=null;function jE(){return ls===null&&(ls=new Cr(JE,16,16,lr,Wi),ls.name="DFG_LUT",ls.minFilter=Kn,ls.magFilter=Kn,ls.wrapS=is,ls.wrapT=is,ls.generateMipmaps=!1,ls.needsUpdate=!0),ls}var lu=class{constructor(e={}){let{canvas:t=s_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:p=ni}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let v=p,f=new Set([Ah,Th,Eh]),m=new Set([ni,Hi,zo,Nr,Sh,Mh]),y=new Uint32Array(4),A=new Int32Array(4),w={textures:[],min:[],max:[],resolution:[]},R=null,E=null,x=[],T=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=as,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,D=!1,W=null,H=null,I=null,O=null;this._outputColorSpace=$n;let q=0,z=0,le=null,K=-1,Q=null,ie=new $t,de=new $t,ue=null,ee=new ct(0),me=0,ge=t.width,xe=t.height,_e=1,Ve=null,$e=null,Fe=new $t(0,0,ge,xe),it=new $t(0,0,ge,xe),at=!1,st=new er,qt=new jc,kt=!1,an=!1,Dt=new Rt,wn=new Y,bt=new $t,_n={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Jt=!1;function ln(){return le===null?_e:1}let F=n;function Re(M,k){return t.getContext(M,k)}let Ye,ot,we,Ut,Ge,Xe,C,b,X,he,oe,ye,be,te,se,pe,U,re,ne,Ee,ve,Me,He;try{let M={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",Je,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),F===null){let k="webgl2";if(F=Re(k,M),F===null)throw Re(k)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ke()}catch(M){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),tt("WebGLRenderer: "+M.message),M}function Ke(){Ye=new c1(F),Ye.init(),ve=new XE(F,Ye),ot=new jw(F,Ye,e,ve),we=new HE(F,Ye),ot.reversedDepthBuffer&&u&&we.buffers.depth.setReversed(!0),H=F.createFramebuffer(),I=F.createFramebuffer(),O=F.createFramebuffer(),Ut=new d1(F),Ge=new RE,Xe=new WE(F,Ye,we,Ge,ot,ve,Ut),C=new l1(N),b=new pS(F),Me=new Kw(F,b),X=new h1(F,b,Ut,Me),he=new p1(F,X,b,Me,Ut),re=new f1(F,ot,Xe),se=new Qw(Ge),oe=new CE(N,C,Ye,ot,Me,se),ye=new ZE(N,Ge),be=new IE,te=new OE(Ye),U=new Zw(N,C,we,he,g,l),pe=new GE(N,he,ot),He=new KE(F,Ut,ot,we),ne=new Jw(F,Ye,Ut),Ee=new u1(F,Ye,Ut),Ut.programs=oe.programs,N.capabilities=ot,N.extensions=Ye,N.properties=Ge,N.renderLists=be,N.shadowMap=pe,N.state=we,N.info=Ut}v!==ni&&(B=new g1(v,t.width,t.height,a,s,r));let ce=new ip(N,F);this.xr=ce,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let M=Ye.get("WEBGL_lose_context");M&&M.loseContext()},this.forceContextRestore=function(){let M=Ye.get("WEBGL_lose_context");M&&M.restoreContext()},this.getPixelRatio=function(){return _e},this.setPixelRatio=function(M){M!==void 0&&(_e=M,this.setSize(ge,xe,!1))},this.getSize=function(M){return M.set(ge,xe)},this.setSize=function(M,k,j=!0){if(ce.isPresenting){qe("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=M,xe=k,t.width=Math.floor(M*_e),t.height=Math.floor(k*_e),j===!0&&(t.style.width=M+"px",t.style.height=k+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,M,k)},this.getDrawingBufferSize=function(M){return M.set(ge*_e,xe*_e).floor()},this.setDrawingBufferSize=function(M,k,j){ge=M,xe=k,_e=j,t.width=Math.floor(M*j),t.height=Math.floor(k*j),this.setViewport(0,0,M,k)},this.setEffects=function(M){if(v===ni){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(M){for(let k=0;k<M.length;k++)if(M[k].isOutputPass===!0){qe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(M||[])},this.getCurrentViewport=function(M){return M.copy(ie)},this.getViewport=function(M){return M.copy(Fe)},this.setViewport=function(M,k,j,$){M.isVector4?Fe.set(M.x,M.y,M.z,M.w):Fe.set(M,k,j,$),we.viewport(ie.copy(Fe).multiplyScalar(ln()).round())},this.getScissor=function(M){return M.copy(it)},this.setScissor=function(M,k,j,$){M.isVector4?it.set(M.x,M.y,M.z,M.w):it.set(M,k,j,$),we.scissor(de.copy(it).multiplyScalar(ln()).round())},this.getScissorTest=function(){return at},this.setScissorTest=function(M){we.setScissorTest(at=M)},this.setOpaqueSort=function(M){Ve=M},this.setTransparentSort=function(M){$e=M},this.getClearColor=function(M){return M.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(M=!0,k=!0,j=!0){let $=0;if(M){let Z=!1;if(le!==null){let Te=le.texture.format;Z=f.has(Te)}if(Z){let Te=le.texture.type,Pe=m.has(Te),Ae=U.getClearColor(),Ie=U.getClearAlpha(),ze=Ae.r,Qe=Ae.g,ft=Ae.b;Pe?(y[0]=ze,y[1]=Qe,y[2]=ft,y[3]=Ie,F.clearBufferuiv(F.COLOR,0,y)):(A[0]=ze,A[1]=Qe,A[2]=ft,A[3]=Ie,F.clearBufferiv(F.COLOR,0,A))}else $|=F.COLOR_BUFFER_BIT}k&&($|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&F.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(M){M.setRenderer(this),W=M},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),U.dispose(),be.dispose(),te.dispose(),Xe.dispose(),Ge.dispose(),C.dispose(),he.dispose(),X.dispose(),Me.dispose(),He.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",dl),ce.removeEventListener("sessionend",qi),fs.stop()};function ke(M){M.preventDefault(),Nf("WebGLRenderer: Context Lost."),D=!0}function Je(){Nf("WebGLRenderer: Context Restored."),D=!1;let M=Ut.autoReset,k=pe.enabled,j=pe.autoUpdate,$=pe.needsUpdate,Z=pe.type;Ke(),Ut.autoReset=M,pe.enabled=k,pe.autoUpdate=j,pe.needsUpdate=$,pe.type=Z}function Ce(M){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",M.statusMessage)}function lt(M){let k=M.target;k.removeEventListener("dispose",lt),Bt(k)}function Bt(M){Vn(M),Ge.remove(M)}function Vn(M){let k=Ge.get(M).programs;k!==void 0&&(k.forEach(function(j){oe.releaseProgram(j)}),M.isShaderMaterial&&oe.releaseShaderCache(M))}this.renderBufferDirect=function(M,k,j,$,Z,Te){k===null&&(k=_n);let Pe=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ae=jo(M,k,j,$,Z);we.setMaterial($,Pe);let Ie=j.index,ze=1;if($.wireframe===!0){if(Ie=X.getWireframeAttribute(j),Ie===void 0)return;ze=2}let Qe=j.drawRange,ft=j.attributes.position,Be=Qe.start*ze,pt=(Qe.start+Qe.count)*ze;Te!==null&&(Be=Math.max(Be,Te.start*ze),pt=Math.min(pt,(Te.start+Te.count)*ze)),Ie!==null?(Be=Math.max(Be,0),pt=Math.min(pt,Ie.count)):ft!=null&&(Be=Math.max(Be,0),pt=Math.min(pt,ft.count));let Zt=pt-Be;if(Zt<0||Zt===1/0)return;Me.setup(Z,$,Ae,j,Ie);let Pt,It=ne;if(Ie!==null&&(Pt=b.get(Ie),It=Ee,It.setIndex(Pt)),Z.isMesh)$.wireframe===!0?(we.setLineWidth($.wireframeLinewidth*ln()),It.setMode(F.LINES)):It.setMode(F.TRIANGLES);else if(Z.isLine){let xn=$.linewidth;xn===void 0&&(xn=1),we.setLineWidth(xn*ln()),Z.isLineSegments?It.setMode(F.LINES):Z.isLineLoop?It.setMode(F.LINE_LOOP):It.setMode(F.LINE_STRIP)}else Z.isPoints?It.setMode(F.POINTS):Z.isSprite&&It.setMode(F.TRIANGLES);if(Z.isBatchedMesh)if(Ye.get("WEBGL_multi_draw"))It.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let xn=Z._multiDrawStarts,Ue=Z._multiDrawCounts,cn=Z._multiDrawCount,_t=Ie?b.get(Ie).bytesPerElement:1,ms=Ge.get($).currentProgram.getUniforms();for(let hn=0;hn<cn;hn++)ms.setValue(F,"_gl_DrawID",hn),It.render(xn[hn]/_t,Ue[hn])}else if(Z.isInstancedMesh)It.renderInstances(Be,Zt,Z.count);else if(j.isInstancedBufferGeometry){let xn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ue=Math.min(j.instanceCount,xn);It.renderInstances(Be,Zt,Ue)}else It.render(Be,Zt)};function Zo(M,k,j,$){W!==null&&M.isNodeMaterial&&W.setObject($,M),kt===!0&&se.setState(M,j,!1),M.transparent===!0&&M.side===ti&&M.forceSinglePass===!1?(M.side=jn,M.needsUpdate=!0,Yi(M,k,$),M.side=ar,M.needsUpdate=!0,Yi(M,k,$),M.side=ti):Yi(M,k,$)}this.compile=function(M,k,j=null){j===null&&(j=M),W!==null&&W.renderStart(M,k,j),E=te.get(j),E.init(k),T.push(E),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(k.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),M!==j&&M.traverseVisible(function(Z){Z.isLight&&Z.layers.test(k.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),E.setupLights(),W!==null&&W.updateLights(E.state.lightsArray),an=this.localClippingEnabled,kt=se.init(this.clippingPlanes,an),kt===!0&&se.setGlobalState(this.clippingPlanes,k),W!==null&&pe.render(E.state.shadowsArray,j,k);let $=new Set;return M.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Te=Z.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ae=Te[Pe];Zo(Ae,j,k,Z),$.add(Ae)}else Zo(Te,j,k,Z),$.add(Te)}),E=T.pop(),W!==null&&W.renderEnd(),$},this.compileAsync=function(M,k,j=null){let $=this.compile(M,k,j);return new Promise(Z=>{function Te(){if($.forEach(function(Pe){let Ie=Ge.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&$.delete(Pe)}),$.size===0){Z(M);return}setTimeout(Te,10)}Ye.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Br=null;function Iu(M){Br&&Br(M)}function dl(){fs.stop()}function qi(){fs.start()}let fs=new U_;fs.setAnimationLoop(Iu),typeof self<"u"&&fs.setContext(self),this.setAnimationLoop=function(M){Br=M,ce.setAnimationLoop(M),M===null?fs.stop():fs.start()},ce.addEventListener("sessionstart",dl),ce.addEventListener("sessionend",qi),this.render=function(M,k){if(k!==void 0&&k.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;W!==null&&W.renderStart(M,k);let j=ce.enabled===!0&&ce.isPresenting===!0,$=B!==null&&(le===null||j)&&B.begin(N,le);if(M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(k),k=ce.getCamera()),M.isScene===!0&&M.onBeforeRender(N,M,k,le),E=te.get(M,T.length),E.init(k),E.state.textureUnits=Xe.getTextureUnits(),T.push(E),Dt.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?qt.setFromArrayCamera(k):st.setFromProjectionMatrix(Dt,Mi,k.reversedDepth),an=this.localClippingEnabled,kt=se.init(this.clippingPlanes,an),R=be.get(M,x.length),R.init(),x.push(R),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=N.xr.getDepthSensingMesh();Pe!==null&&ps(Pe,k,-1/0,N.sortObjects)}ps(M,k,0,N.sortObjects),R.finish(),W!==null&&W.updateLights(E.state.lightsArray),N.sortObjects===!0&&R.sort(Ve,$e),Jt=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,Jt&&U.addToRenderList(R,M),this.info.autoReset===!0&&this.info.reset(),kt===!0&&se.beginShadows();let Z=E.state.shadowsArray;if(pe.render(Z,M,k),kt===!0&&se.endShadows(),($&&B.hasRenderPass())===!1){let Pe=R.opaque,Ae=R.transmissive;if(E.setupLights(),k.isArrayCamera){let Ie=k.cameras;if(Ae.length>0)for(let ze=0,Qe=Ie.length;ze<Qe;ze++){let ft=Ie[ze];Ai(Pe,Ae,M,ft)}Jt&&U.render(M);for(let ze=0,Qe=Ie.length;ze<Qe;ze++){let ft=Ie[ze];Ko(R,M,ft,ft.viewport)}}else Ae.length>0&&Ai(Pe,Ae,M,k),Jt&&U.render(M),Ko(R,M,k)}le!==null&&z===0&&(Xe.updateMultisampleRenderTarget(le),Xe.updateRenderTargetMipmap(le)),$&&B.end(N),M.isScene===!0&&M.onAfterRender(N,M,k),Me.resetDefaultState(),K=-1,Q=null,T.pop(),T.length>0?(E=T[T.length-1],Xe.setTextureUnits(E.state.textureUnits),kt===!0&&se.setGlobalState(N.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?R=x[x.length-1]:R=null,W!==null&&W.renderEnd()};function ps(M,k,j,$){if(M.visible===!1)return;if(M.layers.test(k.layers)){if(M.isGroup)j=M.renderOrder;else if(M.isLOD)M.autoUpdate===!0&&M.update(k);else if(M.isLight)E.pushLight(M),M.castShadow&&E.pushShadow(M);else if(M.isSprite){let Pe=k.isArrayCamera?qt:st;if(!M.frustumCulled||M.intersectsFrustum(Pe)){$&&bt.setFromMatrixPosition(M.matrixWorld).applyMatrix4(Dt);let Ae=he.update(M),Ie=M.material;Ie.visible&&R.push(M,Ae,Ie,j,bt.z,null,k)}}else if(M.isMesh||M.isLine||M.isPoints){let Pe=k.isArrayCamera?qt:st;if(!M.frustumCulled||M.intersectsFrustum(Pe)){let Ae=he.update(M),Ie=M.material;if($&&(M.boundingSphere!==void 0?(M.boundingSphere===null&&M.computeBoundingSphere(),bt.copy(M.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),bt.copy(Ae.boundingSphere.center)),bt.applyMatrix4(M.matrixWorld).applyMatrix4(Dt)),Array.isArray(Ie)){let ze=Ae.groups;for(let Qe=0,ft=ze.length;Qe<ft;Qe++){let Be=ze[Qe],pt=Ie[Be.materialIndex];pt&&pt.visible&&R.push(M,Ae,pt,j,bt.z,Be,k)}}else Ie.visible&&R.push(M,Ae,Ie,j,bt.z,null,k)}}}let Te=M.children;for(let Pe=0,Ae=Te.length;Pe<Ae;Pe++)ps(Te[Pe],k,j,$)}function Ko(M,k,j,$){let{opaque:Z,transmissive:Te,transparent:Pe}=M;E.setupLightsView(j),kt===!0&&se.setGlobalState(N.clippingPlanes,j),$&&we.viewport(ie.copy($)),Z.length>0&&jt(Z,k,j),Te.length>0&&jt(Te,k,j),Pe.length>0&&jt(Pe,k,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Ai(M,k,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[$.id]===void 0){let Be=Ye.has("EXT_color_buffer_half_float")||Ye.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[$.id]=new mi(1,1,{generateMipmaps:!0,type:Be?Wi:ni,minFilter:Ls,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:vt.workingColorSpace})}let Te=E.state.transmissionRenderTarget[$.id],Pe=$.viewport||ie;Te.setSize(Pe.z*N.transmissionResolutionScale,Pe.w*N.transmissionResolutionScale);let Ae=N.getRenderTarget(),Ie=N.getActiveCubeFace(),ze=N.getActiveMipmapLevel();N.setRenderTarget(Te),N.getClearColor(ee),me=N.getClearAlpha(),me<1&&N.setClearColor(16777215,.5),N.clear(),Jt&&U.render(j);let Qe=N.toneMapping;N.toneMapping=as;let ft=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),E.setupLightsView($),kt===!0&&se.setGlobalState(N.clippingPlanes,$),jt(M,j,$),Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te),Ye.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let pt=0,Zt=k.length;pt<Zt;pt++){let Pt=k[pt],{object:It,geometry:xn,material:Ue,group:cn}=Pt;if(Ue.side===ti&&It.layers.test($.layers)){let _t=Ue.side;Ue.side=jn,Ue.needsUpdate=!0,sn(It,j,$,xn,Ue,cn),Ue.side=_t,Ue.needsUpdate=!0,Be=!0}}Be===!0&&(Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te))}N.setRenderTarget(Ae,Ie,ze),N.setClearColor(ee,me),ft!==void 0&&($.viewport=ft),N.toneMapping=Qe}function jt(M,k,j){let $=k.isScene===!0?k.overrideMaterial:null;for(let Z=0,Te=M.length;Z<Te;Z++){let Pe=M[Z],{object:Ae,geometry:Ie,group:ze}=Pe,Qe=Pe.material;Qe.allowOverride===!0&&$!==null&&(Qe=$),Ae.layers.test(j.layers)&&sn(Ae,k,j,Ie,Qe,ze)}}function sn(M,k,j,$,Z,Te){W!==null&&Z.isNodeMaterial&&W.setObject(M,Z),M.onBeforeRender(N,k,j,$,Z,Te),M.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,M.matrixWorld),M.normalMatrix.getNormalMatrix(M.modelViewMatrix),Z.onBeforeRender(N,k,j,$,M,Te),Z.transparent===!0&&Z.side===ti&&Z.forceSinglePass===!1?(Z.side=jn,Z.needsUpdate=!0,N.renderBufferDirect(j,k,$,Z,M,Te),Z.side=ar,Z.needsUpdate=!0,N.renderBufferDirect(j,k,$,Z,M,Te),Z.side=ti):N.renderBufferDirect(j,k,$,Z,M,Te),M.onAfterRender(N,k,j,$,Z,Te)}function rn(M){let k=0;for(let j of M)j.texture!==null&&k++;return k}function Yi(M,k,j){k.isScene!==!0&&(k=_n);let $=Ge.get(M),Z=E.state.lights,Te=E.state.shadowsArray,Pe=Z.state.version,Ae=oe.getParameters(M,Z.state,Te,k,j,E.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Ae),ze=$.programs;$.environment=M.isMeshStandardMaterial||M.isMeshLambertMaterial||M.isMeshPhongMaterial?k.environment:null,$.fog=k.fog;let Qe=M.isMeshStandardMaterial||M.isMeshLambertMaterial&&!M.envMap||M.isMeshPhongMaterial&&!M.envMap;$.envMap=C.get(M.envMap||$.environment,Qe),$.envMapRotation=$.environment!==null&&M.envMap===null?k.environmentRotation:M.envMapRotation,ze===void 0&&(M.addEventListener("dispose",lt),ze=new Map,$.programs=ze,$.programVariants=new Map);let ft=ze.get(Ie);if(ft!==void 0){if($.currentProgram===ft&&$.lightsStateVersion===Pe)return Jo(M,Ae),ft}else Ae.uniforms=oe.getUniforms(M),W!==null&&M.isNodeMaterial&&W.build(M,j,Ae),M.onBeforeCompile(Ae,N),ft=oe.acquireProgram(Ae,Ie),ze.set(Ie,ft),$.uniforms=Ae.uniforms;let Be=$.uniforms;return(!M.isShaderMaterial&&!M.isRawShaderMaterial||M.clipping===!0)&&(Be.clippingPlanes=se.uniform),Jo(M,Ae),$.needsLights=Os(M),$.lightsStateVersion=Pe,$.needsLights&&(Be.ambientLightColor.value=Z.state.ambient,Be.lightProbe.value=Z.state.probe,Be.sunLights.value=Z.state.sun,Be.sunLightShadows.value=Z.state.sunShadow,Be.directionalLights.value=Z.state.directional,Be.directionalLightShadows.value=Z.state.directionalShadow,Be.spotLights.value=Z.state.spot,Be.spotLightShadows.value=Z.state.spotShadow,Be.rectAreaLights.value=Z.state.rectArea,Be.ltc_1.value=Z.state.rectAreaLTC1,Be.ltc_2.value=Z.state.rectAreaLTC2,Be.pointLights.value=Z.state.point,Be.pointLightShadows.value=Z.state.pointShadow,Be.hemisphereLights.value=Z.state.hemi,Be.sunShadowMatrix.value=Z.state.sunShadowMatrix,Be.sunShadowCascade.value=Z.state.sunShadowCascade,Be.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Be.spotLightMatrix.value=Z.state.spotLightMatrix,Be.spotLightMap.value=Z.state.spotLightMap,Be.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=rn(E.state.lightProbeGridArray),$.currentProgram=ft,$.uniformsList=null,ft}function ri(M,k,j,$,Z){let Te=Ge.get(M),Pe=Te.currentProgram.id+","+$+","+Z,Ae=Te.programVariants.get(Pe);return Ae===void 0?(Ae=Yi(M,k,j),Te.programVariants.set(Pe,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=$,Te.toneMapping=Z),Ae}function Fs(M){if(M.uniformsList===null){let k=M.currentProgram.getUniforms();M.uniformsList=Go.seqWithValue(k.seq,M.uniforms)}return M.uniformsList}function Jo(M,k){let j=Ge.get(M);j.outputColorSpace=k.outputColorSpace,j.batching=k.batching,j.batchingColor=k.batchingColor,j.instancing=k.instancing,j.instancingColor=k.instancingColor,j.instancingMorph=k.instancingMorph,j.skinning=k.skinning,j.morphTargets=k.morphTargets,j.morphNormals=k.morphNormals,j.morphColors=k.morphColors,j.morphTargetsCount=k.morphTargetsCount,j.numClippingPlanes=k.numClippingPlanes,j.numIntersection=k.numClipIntersection,j.vertexAlphas=k.vertexAlphas,j.vertexTangents=k.vertexTangents,j.toneMapping=k.toneMapping}function jo(M,k,j,$,Z){k.isScene!==!0&&(k=_n),Xe.resetTextureUnits();let Te=k.fog,Pe=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?k.environment:null,Ae=le===null?N.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:vt.workingColorSpace,Ie=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,ze=C.get($.envMap||Pe,Ie),Qe=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ft=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Be=!!j.morphAttributes.position,pt=!!j.morphAttributes.normal,Zt=!!j.morphAttributes.color,Pt=as;$.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Pt=N.toneMapping);let It=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,xn=It!==void 0?It.length:0,Ue=Ge.get($),cn=E.state.lights;if(kt===!0&&(an===!0||M!==Q)){let Lt=M===Q&&$.id===K;se.setState($,M,Lt)}let _t=!1,ms=!1;$.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==cn.state.version||Z.isBatchedMesh&&Ue.batching===!1||!Z.isBatchedMesh&&Ue.batching===!0||Z.isBatchedMesh&&Ue.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ue.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ue.instancing===!1||!Z.isInstancedMesh&&Ue.instancing===!0||Z.isSkinnedMesh&&Ue.skinning===!1||!Z.isSkinnedMesh&&Ue.skinning===!0||Z.isInstancedMesh&&Ue.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ue.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ue.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ue.instancingMorph===!1&&Z.morphTexture!==null||Ue.envMap!==ze||$.fog===!0&&Ue.fog!==Te||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==se.numPlanes||Ue.numIntersection!==se.numIntersection)||Ue.vertexAlphas!==Qe||Ue.vertexTangents!==ft||Ue.morphTargets!==Be||Ue.morphNormals!==pt||Ue.morphColors!==Zt||Ue.morphTargetsCount!==xn||Ue.numLightProbeGrids!==rn(E.state.lightProbeGridArray)?_t=!0:(Ue.outputColorSpace!==Ae||Ue.toneMapping!==Pt)&&(ms=!0):(_t=!0,Ue.__version=$.version);let hn=Ue.currentProgram;(_t===!0||ms===!0)&&(hn=ms===!0?ri($,k,Z,Ae,Pt):Yi($,k,Z),W&&$.isNodeMaterial&&W.onUpdateProgram($,hn,Ue));let Gr=!1,$i=!1,gs=!1,ht=hn.getUniforms(),Qt=Ue.uniforms;if(we.useProgram(hn.program)&&(Gr=!0,$i=!0,gs=!0),$.id!==K&&(K=$.id,$i=!0),Gr||Q!==M){we.buffers.depth.getReversed()&&M.reversedDepth!==!0&&(M._reversedDepth=!0,M.updateProjectionMatrix()),ht.setValue(F,"projectionMatrix",M.projectionMatrix),ht.setValue(F,"viewMatrix",M.matrixWorldInverse);let un=ht.map.cameraPosition;un!==void 0&&un.setValue(F,wn.setFromMatrixPosition(M.matrixWorld)),ot.logarithmicDepthBuffer&&ht.setValue(F,"logDepthBufFC",2/(Math.log(M.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&ht.setValue(F,"isOrthographic",M.isOrthographicCamera===!0),Q!==M&&(Q=M,$i=!0,gs=!0)}if(Ue.needsLights&&(cn.state.sunShadowMap.length>0&&ht.setValue(F,"sunShadowMap",cn.state.sunShadowMap,Xe),cn.state.directionalShadowMap.length>0&&ht.setValue(F,"directionalShadowMap",cn.state.directionalShadowMap,Xe),cn.state.spotShadowMap.length>0&&ht.setValue(F,"spotShadowMap",cn.state.spotShadowMap,Xe),cn.state.pointShadowMap.length>0&&ht.setValue(F,"pointShadowMap",cn.state.pointShadowMap,Xe)),Z.isSkinnedMesh){ht.setOptional(F,Z,"bindMatrix"),ht.setOptional(F,Z,"bindMatrixInverse");let Lt=Z.skeleton;Lt&&(Lt.boneTexture===null&&Lt.computeBoneTexture(),ht.setValue(F,"boneTexture",Lt.boneTexture,Xe))}Z.isBatchedMesh&&(ht.setOptional(F,Z,"batchingTexture"),ht.setValue(F,"batchingTexture",Z._matricesTexture,Xe),ht.setOptional(F,Z,"batchingIdTexture"),ht.setValue(F,"batchingIdTexture",Z._indirectTexture,Xe),ht.setOptional(F,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ht.setValue(F,"batchingColorTexture",Z._colorsTexture,Xe));let Gn=j.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&re.update(Z,j,hn),($i||Ue.receiveShadow!==Z.receiveShadow)&&(Ue.receiveShadow=Z.receiveShadow,ht.setValue(F,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&k.environment!==null&&(Qt.envMapIntensity.value=k.environmentIntensity),Qt.dfgLUT!==void 0&&(Qt.dfgLUT.value=jE()),$i){if(ht.setValue(F,"toneMappingExposure",N.toneMappingExposure),Ue.needsLights&&zr(Qt,gs),Te&&$.fog===!0&&ye.refreshFogUniforms(Qt,Te),ye.refreshMaterialUniforms(Qt,$,_e,xe,E.state.transmissionRenderTarget[M.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Lt=w,un=0;for(let On of E.state.lightProbeGridArray)On.texture!==null&&(Lt.textures[un]=On.texture,Lt.min[un]=On.boundingBox.min,Lt.max[un]=On.boundingBox.max,Lt.resolution[un]=On.resolution,un++);for(let On in Lt)Lt[On].length=un;Qt.probesSH.value=Lt.textures,Qt.probesMin.value=Lt.min,Qt.probesMax.value=Lt.max,Qt.probesResolution.value=Lt.resolution}Go.upload(F,Fs(Ue),Qt,Xe)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Go.upload(F,Fs(Ue),Qt,Xe),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&ht.setValue(F,"center",Z.center),ht.setValue(F,"modelViewMatrix",Z.modelViewMatrix),ht.setValue(F,"normalMatrix",Z.normalMatrix),ht.setValue(F,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let Lt=$.uniformsGroups;for(let un=0,On=Lt.length;un<On;un++){let fl=Lt[un];He.update(fl,hn),He.bind(fl,hn)}}return hn}function zr(M,k){M.ambientLightColor.needsUpdate=k,M.lightProbe.needsUpdate=k,M.sunLights.needsUpdate=k,M.sunLightShadows.needsUpdate=k,M.directionalLights.needsUpdate=k,M.directionalLightShadows.needsUpdate=k,M.pointLights.needsUpdate=k,M.pointLightShadows.needsUpdate=k,M.spotLights.needsUpdate=k,M.spotLightShadows.needsUpdate=k,M.rectAreaLights.needsUpdate=k,M.hemisphereLights.needsUpdate=k}function Os(M){return M.isMeshLambertMaterial||M.isMeshToonMaterial||M.isMeshPhongMaterial||M.isMeshStandardMaterial||M.isShadowMaterial||M.isShaderMaterial&&M.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(M,k,j){let $=Ge.get(M);$.__autoAllocateDepthBuffer=M.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Ge.get(M.texture).__webglTexture=k,Ge.get(M.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(M,k){let j=Ge.get(M);j.__webglFramebuffer=k,j.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(M,k=0,j=0){le=M,q=k,z=j;let $=null,Z=!1,Te=!1;if(M){let Ae=Ge.get(M);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(F.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(M.viewport),de.copy(M.scissor),ue=M.scissorTest,we.viewport(ie),we.scissor(de),we.setScissorTest(ue),K=-1;return}else if(Ae.__webglFramebuffer===void 0)Xe.setupRenderTarget(M);else if(Ae.__hasExternalTextures)Xe.rebindTextures(M,Ge.get(M.texture).__webglTexture,Ge.get(M.depthTexture).__webglTexture);else if(M.depthBuffer){let Qe=M.depthTexture;if(Ae.__boundDepthTexture!==Qe){if(Qe!==null&&Ge.has(Qe)&&(M.width!==Qe.image.width||M.height!==Qe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xe.setupDepthRenderbuffer(M)}}let Ie=M.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ze=Ge.get(M).__webglFramebuffer;M.isWebGLCubeRenderTarget?(Array.isArray(ze[k])?$=ze[k][j]:$=ze[k],Z=!0):M.samples>0&&Xe.useMultisampledRTT(M)===!1?$=Ge.get(M).__webglMultisampledFramebuffer:Array.isArray(ze)?$=ze[j]:$=ze,ie.copy(M.viewport),de.copy(M.scissor),ue=M.scissorTest}else ie.copy(Fe).multiplyScalar(_e).floor(),de.copy(it).multiplyScalar(_e).floor(),ue=at;if(j!==0&&($=H),we.bindFramebuffer(F.FRAMEBUFFER,$)&&we.drawBuffers(M,$),we.viewport(ie),we.scissor(de),we.setScissorTest(ue),Z){let Ae=Ge.get(M.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+k,Ae.__webglTexture,j)}else if(Te){let Ae=k;for(let Ie=0;Ie<M.textures.length;Ie++){let ze=Ge.get(M.textures[Ie]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,j,Ae)}}else if(M!==null&&j!==0){let Ae=Ge.get(M.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ae.__webglTexture,j)}K=-1};function Vr(M){let k=Ge.get(M);return(k.__readFormat!==M.format||k.__readType!==M.type)&&(k.__readFormat=M.format,k.__readType=M.type,k.__formatReadable=ot.textureFormatReadable(M.format),k.__typeReadable=ot.textureTypeReadable(M.type)),k}this.readRenderTargetPixels=function(M,k,j,$,Z,Te,Pe,Ae=0){if(!(M&&M.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=Ge.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){we.bindFramebuffer(F.FRAMEBUFFER,Ie);try{let ze=M.textures[Ae],Qe=ze.format,ft=ze.type;M.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ae);let Be=Vr(ze);if(Be.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=M.width-$&&j>=0&&j<=M.height-Z&&F.readPixels(k,j,$,Z,ve.convert(Qe),ve.convert(ft),Te)}finally{let ze=le!==null?Ge.get(le).__webglFramebuffer:null;we.bindFramebuffer(F.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(M,k,j,$,Z,Te,Pe,Ae=0){if(!(M&&M.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=Ge.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(k>=0&&k<=M.width-$&&j>=0&&j<=M.height-Z){we.bindFramebuffer(F.FRAMEBUFFER,Ie);let ze=M.textures[Ae],Qe=ze.format,ft=ze.type;M.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ae);let Be=Vr(ze);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,pt),F.bufferData(F.PIXEL_PACK_BUFFER,Te.byteLength,F.STREAM_READ),F.readPixels(k,j,$,Z,ve.convert(Qe),ve.convert(ft),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Zt=le!==null?Ge.get(le).__webglFramebuffer:null;we.bindFramebuffer(F.FRAMEBUFFER,Zt);let Pt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await o_(F,Pt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,pt),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Te),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(pt),F.deleteSync(Pt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(M,k=null,j=0){let $=Math.pow(2,-j),Z=Math.floor(M.image.width*$),Te=Math.floor(M.image.height*$),Pe=k!==null?k.x:0,Ae=k!==null?k.y:0;Xe.setTexture2D(M,0),F.copyTexSubImage2D(F.TEXTURE_2D,j,0,0,Pe,Ae,Z,Te),we.unbindTexture()},this.copyTextureToTexture=function(M,k,j=null,$=null,Z=0,Te=0){let Pe,Ae,Ie,ze,Qe,ft,Be,pt,Zt,Pt=M.isCompressedTexture?M.mipmaps[Te]:M.image;if(j!==null)Pe=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,Qe=j.min.y,ft=j.isBox3?j.min.z:0;else{let ht=Math.pow(2,-Z);Pe=Math.floor(Pt.width*ht),Ae=Math.floor(Pt.height*ht),M.isDataArrayTexture?Ie=Pt.depth:M.isData3DTexture?Ie=Math.floor(Pt.depth*ht):Ie=1,ze=0,Qe=0,ft=0}$!==null?(Be=$.x,pt=$.y,Zt=$.z):(Be=0,pt=0,Zt=0);let It=ve.convert(k.format),xn=ve.convert(k.type),Ue;k.isData3DTexture?(Xe.setTexture3D(k,0),Ue=F.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(Xe.setTexture2DArray(k,0),Ue=F.TEXTURE_2D_ARRAY):(Xe.setTexture2D(k,0),Ue=F.TEXTURE_2D),we.activeTexture(F.TEXTURE0),we.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,k.flipY),we.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),we.pixelStorei(F.UNPACK_ALIGNMENT,k.unpackAlignment);let cn=we.getParameter(F.UNPACK_ROW_LENGTH),_t=we.getParameter(F.UNPACK_IMAGE_HEIGHT),ms=we.getParameter(F.UNPACK_SKIP_PIXELS),hn=we.getParameter(F.UNPACK_SKIP_ROWS),Gr=we.getParameter(F.UNPACK_SKIP_IMAGES);we.pixelStorei(F.UNPACK_ROW_LENGTH,Pt.width),we.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Pt.height),we.pixelStorei(F.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(F.UNPACK_SKIP_ROWS,Qe),we.pixelStorei(F.UNPACK_SKIP_IMAGES,ft);let $i=M.isDataArrayTexture||M.isData3DTexture,gs=k.isDataArrayTexture||k.isData3DTexture;if(M.isDepthTexture){let ht=Ge.get(M),Qt=Ge.get(k),Gn=Ge.get(ht.__renderTarget),Lt=Ge.get(Qt.__renderTarget);we.bindFramebuffer(F.READ_FRAMEBUFFER,Gn.__webglFramebuffer),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,Lt.__webglFramebuffer);for(let un=0;un<Ie;un++)$i&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ge.get(M).__webglTexture,Z,ft+un),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ge.get(k).__webglTexture,Te,Zt+un)),F.blitFramebuffer(ze,Qe,ze+Pe,Qe+Ae,Be,pt,Be+Pe,pt+Ae,F.DEPTH_BUFFER_BIT,F.NEAREST);we.bindFramebuffer(F.READ_FRAMEBUFFER,null),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(Z!==0||M.isRenderTargetTexture||Ge.has(M)){let ht=Ge.get(M),Qt=Ge.get(k);we.bindFramebuffer(F.READ_FRAMEBUFFER,I),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,O);for(let Gn=0;Gn<Ie;Gn++)$i?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ht.__webglTexture,Z,ft+Gn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ht.__webglTexture,Z),gs?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Qt.__webglTexture,Te,Zt+Gn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Qt.__webglTexture,Te),Z!==0?F.blitFramebuffer(ze,Qe,ze+Pe,Qe+Ae,Be,pt,Be+Pe,pt+Ae,F.COLOR_BUFFER_BIT,F.NEAREST):gs?F.copyTexSubImage3D(Ue,Te,Be,pt,Zt+Gn,ze,Qe,Pe,Ae):F.copyTexSubImage2D(Ue,Te,Be,pt,ze,Qe,Pe,Ae);we.bindFramebuffer(F.READ_FRAMEBUFFER,null),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else gs?M.isDataTexture||M.isData3DTexture?F.texSubImage3D(Ue,Te,Be,pt,Zt,Pe,Ae,Ie,It,xn,Pt.data):k.isCompressedArrayTexture?F.compressedTexSubImage3D(Ue,Te,Be,pt,Zt,Pe,Ae,Ie,It,Pt.data):F.texSubImage3D(Ue,Te,Be,pt,Zt,Pe,Ae,Ie,It,xn,Pt):M.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Te,Be,pt,Pe,Ae,It,xn,Pt.data):M.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Te,Be,pt,Pt.width,Pt.height,It,Pt.data):F.texSubImage2D(F.TEXTURE_2D,Te,Be,pt,Pe,Ae,It,xn,Pt);we.pixelStorei(F.UNPACK_ROW_LENGTH,cn),we.pixelStorei(F.UNPACK_IMAGE_HEIGHT,_t),we.pixelStorei(F.UNPACK_SKIP_PIXELS,ms),we.pixelStorei(F.UNPACK_SKIP_ROWS,hn),we.pixelStorei(F.UNPACK_SKIP_IMAGES,Gr),Te===0&&k.generateMipmaps===!0&&k.mipmapsAutoUpdate===!0&&F.generateMipmap(Ue),we.unbindTexture()},this.initRenderTarget=function(M){Ge.get(M).__webglFramebuffer===void 0&&Xe.setupRenderTarget(M)},this.initTexture=function(M){M.isCubeTexture?Xe.setTextureCube(M,0):M.isData3DTexture?Xe.setTexture3D(M,0):M.isDataArrayTexture||M.isCompressedArrayTexture?Xe.setTexture2DArray(M,0):Xe.setTexture2D(M,0),we.unbindTexture()},this.resetState=function(){q=0,z=0,le=null,we.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Mi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=vt._getDrawingBufferColorSpace(e),t.unpackColorSpace=vt._getUnpackColorSpace()}};var q_={type:"change"},rp={type:"start"},$_={type:"end"},uu=new Ar,Y_=new pi,QE=Math.cos(70*kf.DEG2RAD),Mn=new Y,ii=2*Math.PI,Tt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},sp=1e-6,du=class extends Ya{constructor(e,t=null){super(e,t),this.state=Tt.NONE,this.target=new Y,this.cursor=new Y,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:rr.ROTATE,MIDDLE:rr.DOLLY,RIGHT:rr.PAN},this.touches={ONE:or.ROTATE,TWO:or.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new Y,this._lastQuaternion=new Jn,this._lastTargetPosition=new Y,this._quat=new Jn().setFromUnitVectors(e.up,new Y(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Fo,this._sphericalDelta=new Fo,this._scale=1,this._panOffset=new Y,this._rotateStart=new je,this._rotateEnd=new je,this._rotateDelta=new je,this._panStart=new je,this._panEnd=new je,this._panDelta=new je,this._dollyStart=new je,this._dollyEnd=new je,this._dollyDelta=new je,this._dollyDirection=new Y,this._mouse=new je,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=tT.bind(this),this._onPointerDown=eT.bind(this),this._onPointerUp=nT.bind(this),this._onContextMenu=cT.bind(this),this._onMouseWheel=rT.bind(this),this._onKeyDown=oT.bind(this),this._onTouchStart=aT.bind(this),this._onTouchMove=lT.bind(this),this._onMouseDown=iT.bind(this),this._onMouseMove=sT.bind(this),this._interceptControlDown=hT.bind(this),this._interceptControlUp=uT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Tt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(q_),this.update(),this.state=Tt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Mn.copy(t).sub(this.target),Mn.applyQuaternion(this._quat),this._spherical.setFromVector3(Mn),this.autoRotate&&this.state===Tt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ii:n>Math.PI&&(n-=ii),s<-Math.PI?s+=ii:s>Math.PI&&(s-=ii),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Mn.setFromSpherical(this._spherical),Mn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Mn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Mn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new Y(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new Y(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Mn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(uu.origin.copy(this.object.position),uu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(uu.direction))<QE?this.object.lookAt(this.target):(Y_.setFromNormalAndCoplanarPoint(this.object.up,this.target),uu.intersectPlane(Y_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>sp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>sp||this._lastTargetPosition.distanceToSquared(this.target)>sp?(this.dispatchEvent(q_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ii/60*this.autoRotateSpeed*e:ii/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Mn.setFromMatrixColumn(t,0),Mn.multiplyScalar(-e),this._panOffset.add(Mn)}_panUp(e,t){this.screenSpacePanning===!0?Mn.setFromMatrixColumn(t,1):(Mn.setFromMatrixColumn(t,0),Mn.crossVectors(this.object.up,Mn)),Mn.multiplyScalar(e),this._panOffset.add(Mn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Mn.copy(s).sub(this.target);let r=Mn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ii*this._rotateDelta.x/t.clientHeight),this._rotateUp(ii*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ii*this._rotateDelta.x/t.clientHeight),this._rotateUp(ii*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new je,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function eT(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function tT(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function nT(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent($_),this.state=Tt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function iT(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case rr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Tt.DOLLY;break;case rr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Tt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Tt.ROTATE}break;case rr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Tt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Tt.PAN}break;default:this.state=Tt.NONE}this.state!==Tt.NONE&&this.dispatchEvent(rp)}function sT(i){switch(this.state){case Tt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Tt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Tt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function rT(i){this.enabled===!1||this.enableZoom===!1||this.state!==Tt.NONE||(i.preventDefault(),this.dispatchEvent(rp),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent($_))}function oT(i){this.enabled!==!1&&this._handleKeyDown(i)}function aT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case or.ROTATE:if(this.enableRotate===!1){this.state=Tt.NONE;break}this._handleTouchStartRotate(i),this.state=Tt.TOUCH_ROTATE;break;case or.PAN:if(this.enablePan===!1){this.state=Tt.NONE;break}this._handleTouchStartPan(i),this.state=Tt.TOUCH_PAN;break;default:this.state=Tt.NONE}break;case 2:switch(this.touches.TWO){case or.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Tt.TOUCH_DOLLY_PAN;break;case or.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Tt.TOUCH_DOLLY_ROTATE;break;default:this.state=Tt.NONE}break;default:this.state=Tt.NONE}this.state!==Tt.NONE&&this.dispatchEvent(rp)}function lT(i){switch(this._trackPointer(i),this.state){case Tt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Tt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Tt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Tt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Tt.NONE}}function cT(i){this.enabled!==!1&&i.preventDefault()}function hT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function uT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var op=["chase","top","free"],Z_=.52,dT=.29,K_=.16,fT=.5,pT=.18,fu=class{constructor(e,t){this.taken=t;this.camera.up.set(0,0,1),this.controls=new du(this.camera,e),this.controls.enableDamping=!1,this.controls.maxPolarAngle=Math.PI/2-.02,this.controls.minDistance=.15,this.controls.maxDistance=8,this.controls.zoomToCursor=!0,this.controls.addEventListener("start",()=>{this.mode_!=="free"&&(this.mode_="free",this.taken())}),this.controls.addEventListener("change",()=>{this.moved=!0}),this.overview()}taken;camera=new Zn(40,1,.02,60);controls;mode_="free";heading_rad=0;box={min_x:-1,max_x:1,min_y:-1,max_y:1};moved=!0;wantedEye=new Y;wantedTarget=new Y;get mode(){return this.mode_}set(e){e==="free"&&this.mode_==="free"&&this.overview(),this.mode_=e,this.moved=!0}frame(e){this.box=e,this.mode_==="free"&&this.overview(),this.moved=!0}resize(e){this.camera.aspect=e,this.camera.updateProjectionMatrix(),this.mode_==="free"&&this.overview(),this.moved=!0}update(e,t){this.mode_==="chase"&&e!==void 0?this.chase(e,t):this.mode_==="top"&&this.above(t);let n=this.moved;return this.moved=!1,n}overview(){let{x:e,y:t,reach:n}=this.middle(),s=n*1.02;this.controls.target.set(e,t,0),this.camera.position.set(e+.16*s,t-.78*s,.72*s),this.controls.update()}chase(e,t){let n=Math.atan2(Math.sin(e.yaw_rad-this.heading_rad),Math.cos(e.yaw_rad-this.heading_rad));this.heading_rad+=n*(1-Math.exp(-t/fT));let s=Math.cos(this.heading_rad),r=Math.sin(this.heading_rad);this.wantedEye.set(e.x_m-Z_*s,e.y_m-Z_*r,e.z_m+dT),this.wantedTarget.set(e.x_m+K_*s,e.y_m+K_*r,e.z_m+.03),this.glide(t)}above(e){let{x:t,y:n,height:s}=this.middle();this.wantedEye.set(t,n-.002,s),this.wantedTarget.set(t,n,0),this.glide(e)}glide(e){let t=1-Math.exp(-e/pT),{position:n}=this.camera;n.distanceToSquared(this.wantedEye)+this.controls.target.distanceToSquared(this.wantedTarget)<1e-9||(n.lerp(this.wantedEye,t),this.controls.target.lerp(this.wantedTarget,t),this.camera.lookAt(this.controls.target),this.moved=!0)}middle(){let{min_x:e,max_x:t,min_y:n,max_y:s}=this.box,r=Math.tan(this.camera.fov*Math.PI/360),o=t-e+.25,a=s-n+.25,l=Math.max(a,o/this.camera.aspect)/(2*r),c=Math.max(o/this.camera.aspect,a*.85)/(2*r)+.3;return{x:(e+t)/2,y:(n+s)/2,reach:c,height:l}}};var pu=3e-4,ap=.001,Wo=class{poses=[];tracks_m=[];points=[];check(e){let t=e.get("/estimate"),n=qn.map(a=>t?.[a]??void 0),s=[e.leftTrack_m,e.rightTrack_m],r=qn.map(a=>e.path_histories[a].length);return this.poses.length>0&&n.every((a,l)=>mT(a,this.poses[l]))&&s.every((a,l)=>Math.abs(a-(this.tracks_m[l]??NaN))<pu)&&r.every((a,l)=>a===this.points[l])?!1:(this.poses=n,this.tracks_m=s,this.points=r,!0)}reset(){this.poses=[]}};function mT(i,e){return i===void 0||e===void 0?i===e:Math.abs(i.x_m-e.x_m)<pu&&Math.abs(i.y_m-e.y_m)<pu&&Math.abs(i.z_m-e.z_m)<pu&&Math.abs(i.roll_rad-e.roll_rad)<ap&&Math.abs(i.pitch_rad-e.pitch_rad)<ap&&Math.abs(i.yaw_rad-e.yaw_rad)<ap}function lp(i,e){let t=new Fn;return t.setAttribute("position",new In(hm(i,e),3)),t.computeVertexNormals(),t}function Fr(i,e,t,n){let s=lp(i,e),r=new Kt(s,new Gi({color:t}));return r.castShadow=!0,r.receiveShadow=!0,n!==void 0&&r.add(new Vi(new Rr(s,20),new Ei({color:n}))),r}function Xo([i,e,t],[n,s,r],o){let a=Fr([{x:-n/2,y:-r/2},{x:n/2,y:-r/2},{x:n/2,y:r/2},{x:-n/2,y:r/2}],s,o);return a.position.set(i,e,t),a}function rl(i){i.traverse(e=>{if(!(e instanceof Kt||e instanceof Vi))return;e.geometry.dispose();let t=e.material;for(let n of Array.isArray(t)?t:[t])n.map?.dispose(),n.dispose()}),i.clear()}var gu={name:"",length_m:.185,width_m:.2,height_m:.06,gauge_m:.155,axle_spacing_m:.133,wheel_radius_m:.026,shoe_width_m:.045},J_=.012,j_=["000000","011010","001110","010010","011100","000000"],ol=class{constructor(e){this.shape=e;let{axle_spacing_m:t,wheel_radius_m:n,shoe_width_m:s,gauge_m:r}=e,o=wl(t,n-.002),a=this.track(r/2,o),l=this.track(-r/2,o);this.cleats=[a,l];let c=r-s,h=e.height_m-.012;this.group.add(Xo([0,0,(.016+h)/2],[t+n*.9,c-.006,h-.016],"#2b333d"),Xo([0,0,h],[t+n*1.2,c+.01,.003],"#c9d1da"),Xo([-.02,0,h+.004],[.075,.05,.003],"#0f7f86"),Xo([-.054,.012,h+.008],[.014,.012,.01],"#aab3bd"),Xo([t/2+n*.62,0,h-.008],[.006,c*.7,.006],"#fff3c4"),gT(e.height_m)),this.group.rotation.order="ZYX"}shape;group=new wi;cleats;set(e,t,n){tx(this.group,e),this.run(this.cleats[0],t),this.run(this.cleats[1],n)}track(e,t){let{axle_spacing_m:n,wheel_radius_m:s,shoe_width_m:r}=this.shape,o=Fr(t,r,"#1b2026");o.position.y=e,this.group.add(o);for(let c of[-n/2,n/2]){let h=Fr(wl(0,s-.007,10),r+.002,"#8b96a3");h.position.set(c,e,.007),this.group.add(h)}let a=Math.round(Kr(n,s)/J_),l=new Na(new tr(J_*.5,r+.001,.0035),new Gi({color:"#4a545f"}),a);return l.position.y=e,l.castShadow=!0,l.frustumCulled=!1,this.group.add(l),l}run(e,t){let{axle_spacing_m:n,wheel_radius_m:s}=this.shape,r=Kr(n,s);for(let o=0;o<e.count;o++){let a=El(n,s-.002,o*r/e.count-t);Q_.setFromAxisAngle(_T,Math.PI/2-a.outward_rad),ex.compose(vT.set(a.x,0,a.y+5e-4),Q_,xT),e.setMatrixAt(o,ex)}e.instanceMatrix.needsUpdate=!0}},mu=class{group=new wi;constructor(e,t){let n=wl(e.axle_spacing_m,e.wheel_radius_m,6),s=lp(n,e.shoe_width_m),r=new Rr(s,40);s.dispose();for(let o of[-1,1]){let a=new Vi(r,new Ei({color:t,transparent:!0,opacity:.9}));a.position.y=o*e.gauge_m/2,this.group.add(a)}this.group.rotation.order="ZYX"}set(e){tx(this.group,e)}};function tx(i,e){i.position.set(e.x_m,e.y_m,e.z_m),i.rotation.set(e.roll_rad,e.pitch_rad,e.yaw_rad,"ZYX")}function gT(i){let e=j_.length+2,t=new Uint8Array(4*e*e).fill(255);j_.forEach((r,o)=>{for(let a=0;a<r.length;a++){let l=4*((o+1)*e+a+1);r[a]==="0"&&t.fill(16,l,l+3)}});let n=new Cr(t,e,e);n.colorSpace=$n,n.magFilter=mn,n.needsUpdate=!0;let s=new Kt(new rs(.05,.05),new Gi({map:n}));return s.position.set(.045,0,i),s}var _T=new Y(0,1,0),xT=new Y(1,1,1),vT=new Y,Q_=new Jn,ex=new Rt;var nx=.12,yT=.02;function bT(i,e,t){let n=jr(i),s=n.max_x-n.min_x+2*nx,r=n.max_y-n.min_y+2*nx,o=Math.min(e/s,t/r);return{scale:o,left:e/2-o*(n.min_x+n.max_x)/2,top:t/2+o*(n.min_y+n.max_y)/2}}var cr=class{element=document.createElement("canvas");ground=document.createElement("canvas");visible={model:!0,odometry:!0,fused:!0,truth:!0};course;projection={scale:100,left:0,top:0};ratio=1;moved=new Wo;setCourse(e){this.course=e,this.paintGround()}setCamera(e){this.moved.reset()}show(e,t){this.visible[e]=t,this.moved.reset()}resize(){let{clientWidth:e,clientHeight:t}=this.element.parentElement??this.element;e===0||t===0||(this.ratio=Math.min(window.devicePixelRatio,2),this.element.width=this.ground.width=Math.round(e*this.ratio),this.element.height=this.ground.height=Math.round(t*this.ratio),this.paintGround())}draw(e){let t=e.get("/estimate"),n=this.element.getContext("2d");if(n===null||!this.moved.check(e))return;n.setTransform(1,0,0,1,0,0),n.drawImage(this.ground,0,0);for(let r of qn){if(!this.visible[r])continue;let o=e.path_histories[r].coordinates;n.strokeStyle=vi[r],n.lineWidth=2*this.ratio,n.lineJoin="round",n.beginPath();for(let a=0;a<o.length;a+=3){let l=this.pixel(o[a]??0,o[a+1]??0);n.lineTo(l.x,l.y)}n.stroke()}if(t===void 0)return;for(let r of qn){let o=t[r];!o||r===t.steering||!this.visible[r]||(this.polygon(n,Li(ST(o),this.shape.length_m,this.shape.width_m)),n.strokeStyle=vi[r],n.lineWidth=1.5*this.ratio,n.stroke())}let s=t[t.steering];this.robot(n,s,e.leftTrack_m,e.rightTrack_m),this.element.dataset.robot=[s.x_m,s.y_m,s.z_m,s.yaw_rad].join(" ")}reset(){this.moved.reset()}dispose(){this.element.remove()}world(e){let{scale:t,left:n,top:s}=this.projection;return{x:(e.x*this.ratio-n)/t,y:(s-e.y*this.ratio)/t}}get shape(){return this.course?.robot??gu}pixel(e,t){let{scale:n,left:s,top:r}=this.projection;return{x:s+n*e,y:r-n*t}}polygon(e,t){e.beginPath();for(let{x:n,y:s}of t){let r=this.pixel(n,s);e.lineTo(r.x,r.y)}e.closePath()}robot(e,t,n,s){let{axle_spacing_m:r,wheel_radius_m:o,gauge_m:a,shoe_width_m:l}=this.shape,c=this.pixel(t.x_m,t.y_m);e.save(),e.translate(c.x,c.y),e.scale(this.projection.scale,-this.projection.scale),e.rotate(t.yaw_rad);let h=r+2*o;e.fillStyle="#c9d1da",e.fillRect(-.42*h,-(a-l)/2,.84*h,a-l),e.fillStyle="#fff3c4",e.fillRect(.42*h-.008,-.03,.008,.06);let d=Kr(r,o),u=Math.round(d/yT);for(let[p,g]of[[1,n],[-1,s]]){let v=p*a/2-l/2;e.fillStyle="#05080b",e.fillRect(-h/2,v,h,l),e.fillStyle="#5b6672";for(let f=0;f<u;f++){let m=El(r,o,f*d/u-g);m.y>o&&e.fillRect(m.x-.003,v,.006,l)}}e.restore()}paintGround(){let e=this.ground.getContext("2d");if(e===null)return;let{width:t,height:n}=this.ground;this.projection=bT(this.course,t,n),this.moved.reset(),e.fillStyle=Tl,e.fillRect(0,0,t,n),this.grid(e);let s=this.course;if(s!==void 0){for(let r of s.surfaces)this.polygon(e,Li(r,r.length_m,r.width_m)),e.fillStyle=Qr,e.fill();e.strokeStyle=ra,e.lineWidth=this.ratio;for(let r of s.ramps){this.polygon(e,Li(r,Jr(r),r.width_m)),e.fillStyle=Ws,e.fill(),e.stroke();let o=r.height_m/Math.tan(r.up_rad);for(let a of[o-Jr(r)/2,o+r.top_m-Jr(r)/2])this.across(e,r,a,r.width_m)}for(let r of s.blocks)this.polygon(e,Li(r,r.depth_m,r.width_m)),e.fillStyle=Ws,e.fill(),e.stroke();if(s.fence){let{min_x_m:r,max_x_m:o,min_y_m:a,max_y_m:l}=s.fence;this.polygon(e,[{x:r,y:a},{x:o,y:a},{x:o,y:l},{x:r,y:l}]),e.strokeStyle=Rl,e.stroke()}e.setLineDash([6*this.ratio,5*this.ratio]),e.strokeStyle=Di,e.lineWidth=1.5*this.ratio,e.beginPath();for(let r of s.path){let o=this.pixel(r.x_m,r.y_m);e.lineTo(o.x,o.y)}e.stroke(),e.setLineDash([])}}across(e,t,n,s){let r=Math.cos(t.heading_rad),o=Math.sin(t.heading_rad);e.beginPath();for(let a of[-s/2,s/2]){let l=this.pixel(t.x_m+r*n-o*a,t.y_m+o*n+r*a);e.lineTo(l.x,l.y)}e.stroke()}grid(e){let{scale:t,left:n,top:s}=this.projection,{width:r,height:o}=this.ground,a=.1;e.lineWidth=1;let l=(c,h,d,u,p)=>{e.strokeStyle=c?Cl:Al,e.beginPath(),e.moveTo(Math.round(h)+.5,Math.round(d)+.5),e.lineTo(Math.round(u)+.5,Math.round(p)+.5),e.stroke()};for(let c=Math.ceil(-n/t/a);c*a*t+n<r;c++)l(c%5===0,n+c*a*t,0,n+c*a*t,o);for(let c=Math.ceil((s-o)/t/a);c*a*t<s;c++)l(c%5===0,0,s-c*a*t,r,s-c*a*t)}},ST=i=>({x_m:i.x_m,y_m:i.y_m,heading_rad:i.yaw_rad});var qo=class{constructor(e,t,n,s){this.capacity=e;this.width_m=n;this.lift_m=s;this.vertices=new Float32Array(6*e),this.attribute=new In(this.vertices,3),this.indices=new Uint32Array(6*e);for(let a=0;a+1<e;a++)this.indices.set(ix(a),6*a);let r=new Fn;r.setAttribute("position",this.attribute),r.setIndex(new In(this.indices,1)),r.setDrawRange(0,0);let o=new Qs({color:t,side:ti,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-4});this.mesh=new Kt(r,o),this.mesh.frustumCulled=!1}capacity;width_m;lift_m;mesh;vertices;attribute;indices;shown=0;generation=-1;follow(e){if(e.generation===this.generation&&e.length===this.shown)return!1;let t=e.generation===this.generation?Math.max(this.shown-1,0):0;return this.generation=e.generation,this.show(e.coordinates,t),!0}set(e,t=0){let n=Math.min(e.length/3,this.capacity);for(let r=0;r+1<this.capacity;r++){let o=t>0&&Math.floor(r/t)%2===1;this.indices.set(o?[0,0,0,0,0,0]:ix(r),6*r)}let s=this.mesh.geometry.getIndex();s!==null&&(s.needsUpdate=!0),this.show(e.subarray(0,3*n),0)}reset(){this.generation=-1}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}show(e,t){let n=e.length/3;dm(e,t,n,this.width_m,this.lift_m,this.vertices),this.attribute.clearUpdateRanges(),n>t&&this.attribute.addUpdateRange(6*t,6*(n-t)),this.attribute.needsUpdate=!0,this.mesh.geometry.setDrawRange(0,6*Math.max(n-1,0)),this.shown=n}},ix=i=>[2*i,2*i+1,2*i+2,2*i+1,2*i+3,2*i+2];var sx=1.2,MT=.006,wT=5,_u=class{group=new wi;path;set(e){if(this.path?.dispose(),this.path=void 0,rl(this.group),this.floor(e),e!==void 0){for(let t of e.surfaces){let n=new Kt(new rs(t.length_m,t.width_m),new Gi({color:Qr,polygonOffset:!0,polygonOffsetFactor:-1}));n.receiveShadow=!0,cp(n,t),n.position.z=6e-4,this.group.add(n)}for(let t of e.ramps){let n=Fr(Yu(t),t.width_m,Ws,ra);cp(n,t),this.group.add(n)}for(let t of e.blocks){let n=Fr(cm(t),t.width_m,Ws,ra);cp(n,t),this.group.add(n)}if(e.fence){let{min_x_m:t,max_x_m:n,min_y_m:s,max_y_m:r}=e.fence,o={x_m:(t+n)/2,y_m:(s+r)/2,heading_rad:0},a=Li(o,n-t,r-s).flatMap(({x:l,y:c})=>[l,c,.001]);this.group.add(new Fa(hp(a),new Ei({color:Rl})))}if(e.path.length>1){let t=um(e);this.path=new qo(t.length/3,Di,MT,.0015),this.path.set(t,wT),this.group.add(this.path.mesh,rx(e.path[0],.014,.02),rx(e.path.at(-1),.02,.03))}}}floor(e){let t=jr(e),n=.1,s=v=>Math.floor((v-sx)/n)*n,r=v=>Math.ceil((v+sx)/n)*n,[o,a,l,c]=[s(t.min_x),r(t.max_x),s(t.min_y),r(t.max_y)],h=new Kt(new rs(40,40),new Gi({color:Tl,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}));h.position.set((o+a)/2,(l+c)/2,0),h.receiveShadow=!0;let d=[],u=[],p=(v,f,m)=>{for(let y=Math.round(v/n);y<=Math.round(f/n);y++)(y%5===0?u:d).push(...m(y*n))},g=(v,f,m)=>{let y=[];for(let A=Math.round(v/n);A<Math.round(f/n);A+=5)y.push(...m(A*n,Math.min((A+5)*n,f)));return y};p(o,a,v=>g(l,c,(f,m)=>[v,f,0,v,m,0])),p(l,c,v=>g(o,a,(f,m)=>[f,v,0,m,v,0])),this.group.add(h,new Vi(hp(d),new Ei({color:Al})),new Vi(hp(u),new Ei({color:Cl})))}};function cp(i,e){i.position.set(e.x_m,e.y_m,0),i.rotation.z=e.heading_rad}function hp(i){let e=new Fn;return e.setAttribute("position",new In(new Float32Array(i),3)),e}function rx(i,e,t){let n=new Kt(new za(e,t,32),new Qs({color:Di,side:ti,polygonOffset:!0,polygonOffsetFactor:-2}));return n.position.set(i?.x_m??0,i?.y_m??0,.001),n}var xu=class{drawn_ms=-1/0;free_ms=-1/0;slow=0;waiting=!1;level=0;tick(e){if(this.waiting){this.waiting=!1;let t=e-this.drawn_ms;this.free_ms=t>45?e+t*(1/.5-1):-1/0,this.slow=t>45?this.slow+1:Math.max(0,this.slow-1),this.slow>40&&this.level<2&&(this.level++,this.slow=0)}return e>=this.free_ms}drawn(e){this.drawn_ms=e,this.waiting=!0}};var ET=.007,TT={model:.002,odometry:.0025,fused:.003,truth:.0035},AT=2,vu=class{element;renderer;scene=new Pa;rig;sun=new qa("#ffffff",2.2);course=new _u;ribbons;ghosts;robot;shape=gu;visible={model:!0,odometry:!0,fused:!0,truth:!0};pace=new xu;level=0;lag_s=0;moved=new Wo;changed=!0;constructor(e,t){this.renderer=new lu({antialias:!0,powerPreference:"low-power"}),this.element=this.renderer.domElement,this.element.addEventListener("webglcontextlost",t),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=Pr,this.scene.background=new ct($u),this.scene.fog=new Ra($u,3.5,9),this.scene.add(new Ha("#bcd6f5","#26303c",1.4),this.sun,this.sun.target,this.course.group),this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.bias=-4e-4,this.sun.shadow.normalBias=.002,this.rig=new fu(this.element,e),this.ribbons=ox(n=>new qo(4e3,vi[n],ET,TT[n]));for(let n of qn)this.scene.add(this.ribbons[n].mesh);this.robot=new ol(this.shape),this.ghosts=this.makeGhosts(),this.scene.add(this.robot.group),this.setCourse(void 0)}setCourse(e){this.course.set(e);let t=jr(e);this.rig.frame(t);let n=(t.min_x+t.max_x)/2,s=(t.min_y+t.max_y)/2,r=Math.hypot(t.max_x-t.min_x,t.max_y-t.min_y)/2+.2;this.sun.target.position.set(n,s,0),this.sun.position.set(n-.6*r,s-.35*r,1.4*r);let o=this.sun.shadow.camera;if([o.left,o.right,o.bottom,o.top]=[-r,r,-r,r],[o.near,o.far]=[.1,4*r],o.updateProjectionMatrix(),e!==void 0&&JSON.stringify(e.robot)!==JSON.stringify(this.shape)){this.shape=e.robot;for(let a of[this.robot,...Object.values(this.ghosts)])this.scene.remove(a.group),rl(a.group);this.robot=new ol(this.shape),this.scene.add(this.robot.group),this.ghosts=this.makeGhosts()}this.moved.reset(),this.changed=!0}setCamera(e){this.rig.set(e),this.changed=!0}show(e,t){this.visible[e]=t,this.moved.reset()}draw(e,t){let n=performance.now();if(this.lag_s+=t,!this.pace.tick(n))return;this.degrade();for(let l of qn){let c=this.ribbons[l];c.follow(e.path_histories[l])&&(this.changed=!0),c.mesh.visible=this.visible[l]}let s=e.get("/estimate");if(this.moved.check(e)){this.changed=!0,this.robot.group.visible=s!==void 0,s!==void 0&&this.robot.set(s[s.steering],e.leftTrack_m,e.rightTrack_m);for(let l of qn){let c=s?.[l],h=this.ghosts[l];h.group.visible=!!c&&l!==s.steering&&this.visible[l],c&&h.set(c)}}let r=this.rig.update(e.pose,this.lag_s);if(this.lag_s=0,!r&&!this.changed)return;this.changed=!1,this.renderer.render(this.scene,this.rig.camera),this.pace.drawn(n);let{position:o,rotation:a}=this.robot.group;s!==void 0&&(this.element.dataset.robot=[o.x,o.y,o.z,a.z].join(" "))}reset(){this.moved.reset();for(let e of qn)this.ribbons[e].reset()}resize(){let{clientWidth:e,clientHeight:t}=this.element.parentElement??this.element;e===0||t===0||(this.renderer.setPixelRatio(this.level>1?.6:Math.min(window.devicePixelRatio,AT)),this.renderer.setSize(e,t),this.rig.resize(e/t),this.changed=!0)}dispose(){rl(this.scene),this.renderer.dispose(),this.element.remove()}degrade(){this.pace.level!==this.level&&(this.level=this.pace.level,this.sun.castShadow=!1,this.level>1&&this.resize())}makeGhosts(){return ox(e=>{let t=new mu(this.shape,vi[e]);return t.group.visible=!1,this.scene.add(t.group),t})}};function ox(i){return{model:i("model"),odometry:i("odometry"),fused:i("fused"),truth:i("truth")}}var yu=[...op,"map"],bu=class{element=G("section",{class:"viewport","aria-label":"Course"});stage=G("div",{class:"stage"});buttons=new Map;toggles=new Map;hidden=new Set;view;mode="free";webgl=!0;course;courseShown=-1;constructor(){let e=G("div",{class:"modes",role:"group","aria-label":"Camera"});for(let o of yu){let a=G("button",{type:"button","aria-pressed":"false",id:`camera-${o}`},o);a.addEventListener("click",()=>{this.set(o)}),this.buttons.set(o,a),e.append(a)}let t=G("div",{class:"key",role:"group","aria-label":"Paths"}),n=G("i",{class:"swatch dashed"});n.style.color=Di,t.append(G("span",{class:"key-item"},n,"plan"));for(let o of qn){let a=G("i",{class:"swatch"});a.style.color=vi[o];let l=G("button",{type:"button",class:"key-item","aria-pressed":"true",id:`show-${o}`},a,o);l.addEventListener("click",()=>{this.toggle(o)}),this.toggles.set(o,l),t.append(l)}this.element.append(this.stage,t,e);let s=CT();s==="nothing"&&this.withoutWebgl();let r=s==="card"?"free":"map";this.view=this.make(r),this.set(this.view instanceof cr?"map":r),new ResizeObserver(()=>{this.view.resize()}).observe(this.stage)}set(e){if(e!=="map"&&!this.webgl)return;this.view instanceof cr!==(e==="map")&&(this.view.dispose(),this.view=this.make(e)),this.mode=this.view instanceof cr?"map":e,this.mode!=="map"&&this.view.setCamera(this.mode),this.mark()}next(){let e=this.webgl?yu:["map"];this.set(e[(e.indexOf(this.mode)+1)%e.length]??"map")}world(e){return this.view instanceof cr?this.view.world(e):void 0}draw(e,t){let n=e.received["/course"]??0;n!==this.courseShown&&(this.courseShown=n,this.course=e.get("/course"),this.view.setCourse(this.course));let s=this.toggles.get("truth");s&&nn(s,"absent",!e.get("/estimate")?.truth),nn(this.element,"stale",e.stale("/estimate")),this.view.draw(e,t)}reset(){this.courseShown=-1,this.view.reset()}toggle(e){this.hidden.delete(e)||this.hidden.add(e);let t=!this.hidden.has(e);this.view.show(e,t);let n=this.toggles.get(e);n&&yt(n,"aria-pressed",String(t))}make(e){let t=this.scene(e)??new cr;this.stage.replaceChildren(t.element),t.element.setAttribute("aria-hidden","true"),t.resize(),t.setCourse(this.course);for(let n of this.hidden)t.show(n,!1);return t}scene(e){if(!(e==="map"||!this.webgl))try{return new vu(()=>{this.mode="free",this.mark()},()=>{this.withoutWebgl(),this.set("map")})}catch{this.withoutWebgl();return}}withoutWebgl(){this.webgl=!1;for(let e of op){let t=this.buttons.get(e);t!==void 0&&(t.disabled=!0,t.title="This browser has no WebGL")}}mark(){for(let[e,t]of this.buttons)yt(t,"aria-pressed",String(e===this.mode))}};function CT(){let i=document.createElement("canvas").getContext("webgl2");if(i===null)return"nothing";let e=i.getExtension("WEBGL_debug_renderer_info"),t=String(i.getParameter(e?.UNMASKED_RENDERER_WEBGL??i.RENDERER));return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)?"processor":"card"}var Su=class{constructor(e,t){this.frames=e;this.store=t;this.begin_s=e.find(n=>n.topic==="/estimate")?.time_s??0,this.end_s=e.at(-1)?.time_s??0,this.at_s=this.begin_s,this.seek(this.begin_s)}frames;store;begin_s;end_s;playing=!1;speed=1;next=0;at_s;get duration_s(){return this.end_s-this.begin_s}get position_s(){return this.at_s-this.begin_s}seek(e){let t=Math.min(Math.max(e,this.begin_s),this.end_s);t<this.at_s&&(this.next=0,this.store.clear()),this.at_s=t;for(let n=this.frames[this.next];n!==void 0&&n.time_s<=t;n=this.frames[++this.next])this.store.receive(n.topic,n.message)}show(e){this.seek(this.begin_s+e)}tick(e){if(this.playing){if(this.at_s>=this.end_s){this.playing=!1;return}this.seek(this.at_s+e*this.speed)}}toggle(){!this.playing&&this.at_s>=this.end_s&&this.seek(this.begin_s),this.playing=!this.playing}};var RT=ArrayBuffer,on=Uint8Array,Mu=Uint16Array,PT=Int16Array;var wu=Int32Array,up=function(i,e,t){if(on.prototype.slice)return on.prototype.slice.call(i,e,t);(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length);var n=new on(t-e);return n.set(i.subarray(e,t)),n},ll=function(i,e,t,n){if(on.prototype.fill)return on.prototype.fill.call(i,e,t,n);for((t==null||t<0)&&(t=0),(n==null||n>i.length)&&(n=i.length);t<n;++t)i[t]=e;return i},IT=function(i,e,t,n){if(on.prototype.copyWithin)return on.prototype.copyWithin.call(i,e,t,n);for((t==null||t<0)&&(t=0),(n==null||n>i.length)&&(n=i.length);t<n;)i[e++]=i[t++]};var LT=["invalid zstd data","window size too large (>2046MB)","invalid block type","FSE accuracy too high","match distance too far back","unexpected EOF"],gn=function(i,e,t){var n=new Error(e||LT[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,gn),!t)throw n;return n},ax=function(i,e,t){for(var n=0,s=0;n<t;++n)s|=i[e++]<<(n<<3);return s},DT=function(i,e){return(i[e]|i[e+1]<<8|i[e+2]<<16|i[e+3]<<24)>>>0},NT=function(i,e){var t=i[0]|i[1]<<8|i[2]<<16;if(t==3126568&&i[3]==253){var n=i[4],s=n>>5&1,r=n>>2&1,o=n&3,a=n>>6;n&8&&gn(0);var l=6-s,c=o==3?4:o,h=ax(i,l,c);l+=c;var d=a?1<<a:s,u=ax(i,l,d)+(a==1&&256),p=u;if(!s){var g=1<<10+(i[5]>>3);p=g+(g>>3)*(i[5]&7)}p>2145386496&&gn(1);var v=new on((e==1?u||p:e?0:p)+12);return v[0]=1,v[4]=4,v[8]=8,{b:l+d,y:0,l:0,d:h,w:e&&e!=1?e:v.subarray(12),e:p,o:new wu(v.buffer,0,3),u,c:r,m:Math.min(131072,p)}}else if((t>>4|i[3]<<20)==25481893)return DT(i,4)+8;gn(0)},Or=function(i){for(var e=0;1<<e<=i;++e);return e-1},cl=function(i,e,t){var n=(e<<3)+4,s=(i[e]&15)+5;s>t&&gn(3);for(var r=1<<s,o=r,a=-1,l=-1,c=-1,h=r,d=new RT(512+(r<<2)),u=new PT(d,0,256),p=new Mu(d,0,256),g=new Mu(d,512,r),v=512+(r<<1),f=new on(d,v,r),m=new on(d,v+r);a<255&&o>0;){var y=Or(o+1),A=n>>3,w=(1<<y+1)-1,R=(i[A]|i[A+1]<<8|i[A+2]<<16)>>(n&7)&w,E=(1<<y)-1,x=w-o-1,T=R&E;if(T<x?(n+=y,R=T):(n+=y+1,R>E&&(R-=x)),u[++a]=--R,R==-1?(o+=R,f[--h]=a):o-=R,!R)do{var B=n>>3;l=(i[B]|i[B+1]<<8)>>(n&7)&3,n+=2,a+=l}while(l==3)}(a>255||o)&&gn(0);for(var N=0,D=(r>>1)+(r>>3)+3,W=r-1,H=0;H<=a;++H){var I=u[H];if(I<1){p[H]=-I;continue}for(c=0;c<I;++c){f[N]=H;do N=N+D&W;while(N>=h)}}for(N&&gn(0),c=0;c<r;++c){var O=p[f[c]]++,q=m[c]=s-Or(O);g[c]=(O<<q)-r}return[n+7>>3,{b:s,s:f,n:m,t:g}]},UT=function(i,e){var t=0,n=-1,s=new on(292),r=i[e],o=s.subarray(0,256),a=s.subarray(256,268),l=new Mu(s.buffer,268);if(r<128){var c=cl(i,e+1,6),h=c[0],d=c[1];e+=r;var u=h<<3,p=i[e];p||gn(0);for(var g=0,v=0,f=d.b,m=f,y=(++e<<3)-8+Or(p);y-=f,!(y<u);){var A=y>>3;if(g+=(i[A]|i[A+1]<<8)>>(y&7)&(1<<f)-1,o[++n]=d.s[g],y-=m,y<u)break;A=y>>3,v+=(i[A]|i[A+1]<<8)>>(y&7)&(1<<m)-1,o[++n]=d.s[v],f=d.n[g],g=d.t[g],m=d.n[v],v=d.t[v]}++n>255&&gn(0)}else{for(n=r-127;t<n;t+=2){var w=i[++e];o[t]=w>>4,o[t+1]=w&15}++e}var R=0;for(t=0;t<n;++t){var E=o[t];E>11&&gn(0),R+=E&&1<<E-1}var x=Or(R)+1,T=1<<x,B=T-R;for(B&B-1&&gn(0),o[n++]=Or(B)+1,t=0;t<n;++t){var E=o[t];++a[o[t]=E&&x+1-E]}var N=new on(T<<1),D=N.subarray(0,T),W=N.subarray(T);for(l[x]=0,t=x;t>0;--t){var H=l[t];ll(W,t,H,l[t-1]=H+a[t]*(1<<x-t))}for(l[0]!=T&&gn(0),t=0;t<n;++t){var I=o[t];if(I){var O=l[I];ll(D,t,O,l[I]=O+(1<<x-I))}}return[e,{n:W,b:x,s:D}]},FT=cl(new on([81,16,99,140,49,198,24,99,12,33,196,24,99,102,102,134,70,146,4]),0,6)[1],OT=cl(new on([33,20,196,24,99,140,33,132,16,66,8,33,132,16,66,8,33,68,68,68,68,68,68,68,68,36,9]),0,6)[1],kT=cl(new on([32,132,16,66,102,70,68,68,68,68,36,73,2]),0,5)[1],lx=function(i,e){for(var t=i.length,n=new wu(t),s=0;s<t;++s)n[s]=e,e+=1<<i[s];return n},dp=new on(new wu([0,0,0,0,16843009,50528770,134678020,202050057,269422093]).buffer,0,36),BT=lx(dp,0),fp=new on(new wu([0,0,0,0,0,0,0,0,16843009,50528770,117769220,185207048,252579084,16]).buffer,0,53),zT=lx(fp,3),al=function(i,e,t){var n=i.length,s=e.length,r=i[n-1],o=(1<<t.b)-1,a=-t.b;r||gn(0);for(var l=0,c=t.b,h=(n<<3)-8+Or(r)-c,d=-1;h>a&&d<s;){var u=h>>3,p=(i[u]|i[u+1]<<8|i[u+2]<<16)>>(h&7);l=(l<<c|p)&o,e[++d]=t.s[l],h-=c=t.n[l]}(h!=a||d+1!=s)&&gn(0)},VT=function(i,e,t){var n=6,s=e.length,r=s+3>>2,o=r<<1,a=r+o;al(i.subarray(n,n+=i[0]|i[1]<<8),e.subarray(0,r),t),al(i.subarray(n,n+=i[2]|i[3]<<8),e.subarray(r,o),t),al(i.subarray(n,n+=i[4]|i[5]<<8),e.subarray(o,a),t),al(i.subarray(n),e.subarray(a),t)},GT=function(i,e,t){var n,s=e.b,r=i[s],o=r>>1&3;e.l=r&1;var a=r>>3|i[s+1]<<5|i[s+2]<<13,l=(s+=3)+a;if(o==1)return s>=i.length?void 0:(e.b=s+1,t?(ll(t,i[s],e.y,e.y+=a),t):ll(new on(a),i[s]));if(!(l>i.length)){if(o==0)return e.b=l,t?(t.set(i.subarray(s,l),e.y),e.y+=a,t):up(i,s,l);if(o==2){var c=i[s],h=c&3,d=c>>2&3,u=c>>4,p=0,g=0;h<2?d&1?u|=i[++s]<<4|(d&2&&i[++s]<<12):u=c>>3:(g=d,d<2?(u|=(i[++s]&63)<<4,p=i[s]>>6|i[++s]<<2):d==2?(u|=i[++s]<<4|(i[++s]&3)<<12,p=i[s]>>2|i[++s]<<6):(u|=i[++s]<<4|(i[++s]&63)<<12,p=i[s]>>6|i[++s]<<2|i[++s]<<10)),++s;var v=t?t.subarray(e.y,e.y+e.m):new on(e.m),f=v.length-u;if(h==0)v.set(i.subarray(s,s+=u),f);else if(h==1)ll(v,i[s++],f);else{var m=e.h;if(h==2){var y=UT(i,s);p+=s-(s=y[0]),e.h=m=y[1]}else m||gn(0);(g?VT:al)(i.subarray(s,s+=p),v.subarray(f),m)}var A=i[s++];if(A){A==255?A=(i[s++]|i[s++]<<8)+32512:A>127&&(A=A-128<<8|i[s++]);var w=i[s++];w&3&&gn(0);for(var R=[OT,kT,FT],E=2;E>-1;--E){var x=w>>(E<<1)+2&3;if(x==1){var T=new on([0,0,i[s++]]);R[E]={s:T.subarray(2,3),n:T.subarray(0,1),t:new Mu(T.buffer,0,1),b:0}}else x==2?(n=cl(i,s,9-(E&1)),s=n[0],R[E]=n[1]):x==3&&(e.t||gn(0),R[E]=e.t[E])}var B=e.t=R,N=B[0],D=B[1],W=B[2],H=i[l-1];H||gn(0);var I=(l<<3)-8+Or(H)-W.b,O=I>>3,q=0,z=(i[O]|i[O+1]<<8)>>(I&7)&(1<<W.b)-1;O=(I-=D.b)>>3;var le=(i[O]|i[O+1]<<8)>>(I&7)&(1<<D.b)-1;O=(I-=N.b)>>3;var K=(i[O]|i[O+1]<<8)>>(I&7)&(1<<N.b)-1;for(++A;--A;){var Q=W.s[z],ie=W.n[z],de=N.s[K],ue=N.n[K],ee=D.s[le],me=D.n[le];O=(I-=ee)>>3;var ge=1<<ee,xe=ge+((i[O]|i[O+1]<<8|i[O+2]<<16|i[O+3]<<24)>>>(I&7)&ge-1);O=(I-=fp[de])>>3;var _e=zT[de]+((i[O]|i[O+1]<<8|i[O+2]<<16)>>(I&7)&(1<<fp[de])-1);O=(I-=dp[Q])>>3;var Ve=BT[Q]+((i[O]|i[O+1]<<8|i[O+2]<<16)>>(I&7)&(1<<dp[Q])-1);if(O=(I-=ie)>>3,z=W.t[z]+((i[O]|i[O+1]<<8)>>(I&7)&(1<<ie)-1),O=(I-=ue)>>3,K=N.t[K]+((i[O]|i[O+1]<<8)>>(I&7)&(1<<ue)-1),O=(I-=me)>>3,le=D.t[le]+((i[O]|i[O+1]<<8)>>(I&7)&(1<<me)-1),xe>3)e.o[2]=e.o[1],e.o[1]=e.o[0],e.o[0]=xe-=3;else{var $e=xe-(Ve!=0);$e?(xe=$e==3?e.o[0]-1:e.o[$e],$e>1&&(e.o[2]=e.o[1]),e.o[1]=e.o[0],e.o[0]=xe):xe=e.o[0]}for(var E=0;E<Ve;++E)v[q+E]=v[f+E];q+=Ve,f+=Ve;var Fe=q-xe;if(Fe<0){var it=-Fe,at=e.e+Fe;it>_e&&(it=_e);for(var E=0;E<it;++E)v[q+E]=e.w[at+E];q+=it,_e-=it,Fe=0}for(var E=0;E<_e;++E)v[q+E]=v[Fe+E];q+=_e}if(q!=f)for(;f<v.length;)v[q++]=v[f++];else q=v.length;t?e.y+=q:v=up(v,0,q)}else if(t){if(e.y+=u,f)for(var E=0;E<u;++E)v[E]=v[f+E]}else f&&(v=up(v,f));return e.b=l,v}gn(2)}},HT=function(i,e){if(i.length==1)return i[0];for(var t=new on(e),n=0,s=0;n<i.length;++n){var r=i[n];t.set(r,s),s+=r.length}return t};function cx(i,e){for(var t=[],n=+!e,s=0,r=0;i.length;){var o=NT(i,n||e);if(typeof o=="object"){for(n?(e=null,o.w.length==o.u&&(t.push(e=o.w),r+=o.u)):(t.push(e),o.e=0);!o.l;){var a=GT(i,o,e);a||gn(5),e?o.e=o.y:(t.push(a),r+=a.length,IT(o.w,0,a.length),o.w.set(a,o.w.length-a.length))}s=o.b+o.c*4}else s=o;i=i.subarray(s)}return HT(t,r)}var pp=[137,77,67,65,80,48,13,10],hl={header:1,footer:2,schema:3,channel:4,message:5,chunk:6,dataEnd:15},hs=9,hx=64*1024*1024,Eu=class{constructor(e,t=()=>!0){this.received=e;this.wanted=t}received;wanted;buffer=new Uint8Array(65536);begin=0;end=0;begun=!1;topics=new Map;ended=!1;push(e){if(!this.ended){if(this.append(e),!this.begun){if(this.end-this.begin<pp.length)return;if(pp.some((t,n)=>this.buffer[this.begin+n]!==t))throw new Error("not an MCAP file");this.begin+=pp.length,this.begun=!0}for(;this.end-this.begin>=hs;){let t=new DataView(this.buffer.buffer,this.begin,this.end-this.begin),n=Number(t.getBigUint64(1,!0));if(n>hx)throw new Error("the recording is corrupted: a record of impossible length");if(t.byteLength<hs+n)break;let s=this.buffer.subarray(this.begin+hs,this.begin+hs+n);this.begin+=hs+n;let r=t.getUint8(0);if(r===hl.dataEnd||r===hl.footer){this.ended=!0;break}this.record(r,s)}}}append(e){let t=this.end-this.begin;if(this.end+e.length>this.buffer.length){let n=Math.max(this.buffer.length,t+e.length),s=n>this.buffer.length?new Uint8Array(2*n):this.buffer;s.set(this.buffer.subarray(this.begin,this.end)),this.buffer=s,this.begin=0,this.end=t}this.buffer.set(e,this.end),this.end+=e.length}record(e,t){let n=new DataView(t.buffer,t.byteOffset,t.byteLength);if(e===hl.channel&&t.length>=8)this.topics.set(n.getUint16(0,!0),ux(t,n,4).text);else if(e===hl.message&&t.length>=22){let s=this.topics.get(n.getUint16(0,!0)),r=Number(n.getBigUint64(6,!0))*1e-9;s!==void 0&&this.wanted(s,r)&&this.received({topic:s,time_s:r,data:t.subarray(22)})}else e===hl.chunk&&t.length>=32&&this.chunk(t,n)}chunk(e,t){let n=Number(t.getBigUint64(16,!0));if(n>hx)throw new Error("the recording is corrupted: a chunk of impossible length");let s=ux(e,t,28),r=e.subarray(s.next+8),o=r;if(s.text==="zstd")o=cx(r,new Uint8Array(n));else if(s.text!=="")throw new Error(`chunks compressed with "${s.text}" cannot be read here`);let a=0;for(;o.length-a>=hs;){let l=new DataView(o.buffer,o.byteOffset+a),c=Number(l.getBigUint64(1,!0));if(c>o.length-a-hs)throw new Error("the recording is corrupted: a chunk ends too early");this.record(l.getUint8(0),o.subarray(a+hs,a+hs+c)),a+=hs+c}}},WT=new TextDecoder;function ux(i,e,t){let n=e.getUint32(t,!0);if(n>i.length-t-4)throw new Error("the recording is corrupted: a text ends too early");return{text:WT.decode(i.subarray(t+4,t+4+n)),next:t+4+n}}var Tu=class{constructor(e,t){this.capacity=e;this.interval_s=t}capacity;interval_s;items=[];wants(e){let t=this.items.at(-1);return t===void 0||e-t.time_s>=this.interval_s}add(e,t){if(this.wants(e)){if(this.items.length===this.capacity){for(let s=0;2*s<this.capacity;s++){let r=this.items[2*s];r!==void 0&&(this.items[s]=r)}this.items.length=Math.ceil(this.capacity/2);let n=(this.items.at(-1)?.time_s??0)-(this.items[0]?.time_s??0);if(this.interval_s=Math.max(2*this.interval_s,n/this.items.length),!this.wants(e))return}this.items.push({time_s:e,item:t})}}};var XT={"/course":[4,0],"/estimate":[2e4,.0199],"/slip":[8e3,.049],"/state":[8e3,0],"/event":[2e3,0],"/link":[2e3,.19],"/loop":[2e3,.49]},mp=class{topics=new Map;decoder=new TextDecoder;scanner;constructor(){for(let[e,[t,n]]of Object.entries(XT))this.topics.set(e,new Tu(t,n));this.scanner=new Eu(({topic:e,time_s:t,data:n})=>{try{this.topics.get(e)?.add(t,JSON.parse(this.decoder.decode(n)))}catch{}},(e,t)=>this.topics.get(e)?.wants(t)===!0)}push(e){this.scanner.push(e)}frames(){let e=[];for(let[t,n]of this.topics)for(let{time_s:s,item:r}of n.items)e.push({time_s:s,topic:t,message:r});return e.sort((t,n)=>t.time_s-n.time_s)}};async function dx(i,e,t){let n=await fetch(i,{signal:t});if(!n.ok||n.body===null)throw new Error(`${i}: ${n.status} ${n.statusText}`);let s=Number(n.headers.get("Content-Length")??NaN),r=n.body.getReader(),o=new mp,a=0;for(;;){let{done:c,value:h}=await r.read();if(c)break;a+=h.length,o.push(h),s>0&&e(a/s)}let l=o.frames();if(!l.some(c=>c.topic==="/estimate"))throw new Error("the recording holds no poses");return l}var Au=class{press_;daemon;lastTook_ms=null;get unsent(){return this.press_!==void 0&&!this.press_.sent}press(e){this.press_={at_ms:e,sent:!1,received:!1}}sent(){this.press_!==void 0&&(this.press_.sent=!0)}answered(e,t){this.press_!==void 0&&(e?(this.press_=void 0,this.lastTook_ms=t,this.daemon!==void 0&&(this.daemon={...this.daemon,latched:!0,status:"acknowledged",acknowledged_ms:t})):this.press_.received=!0)}disconnected(){this.press_!==void 0&&(this.press_.sent=!1,this.press_.received=!1)}received(e){this.daemon=e,this.lastTook_ms=e.acknowledged_ms??this.lastTook_ms,this.press_?.received===!0&&(e.status==="acknowledged"||!e.latched)&&(this.press_=void 0)}view(e){let t=this.press_;if(t!==void 0){let s=e-t.at_ms;return s<200?{kind:"pending"}:{kind:"not_acknowledged",since_ms:s,waiting:!t.sent}}let n=this.daemon;return n?.latched!==!0?{kind:"ready"}:n.status==="acknowledged"||n.status==="none"?{kind:"stopped",took_ms:n.acknowledged_ms??this.lastTook_ms,by:n.by}:n.status==="pending"?{kind:"pending"}:{kind:"not_acknowledged",since_ms:200,waiting:!1}}};function gp(i){return i instanceof HTMLElement&&i.matches("input:not([type=range]), select, textarea")}function fx(i){window.addEventListener("keydown",e=>{if(e.key==="Escape"||e.code==="Space"&&!gp(e.target)){e.preventDefault(),e.repeat||i.stop();return}if(!(e.ctrlKey||e.metaKey||e.altKey||gp(e.target))){if(i.driveKey(e.code,!0)){e.preventDefault(),e.stopPropagation();return}e.key==="r"&&!e.repeat?i.start():e.key==="h"&&!e.repeat?i.hold():e.key==="m"&&!e.repeat?i.drive():e.key==="c"?i.nextCamera():e.key>="1"&&e.key<="4"?i.camera(Number(e.key)-1):e.key==="?"?i.keys():e.key==="["?i.step(-1):e.key==="]"&&i.step(1)}},{capture:!0}),window.addEventListener("keyup",e=>{e.code==="Space"&&!gp(e.target)&&e.preventDefault(),i.driveKey(e.code,!1)},{capture:!0})}var YT=["/state","/course","/path_history","/estimate","/slip","/link","/loop","/event","/parameter","/recording","/client"],$T=250,ZT=100,KT=1e3/30-8,JT=100,jT=200,QT=60,si=new oa,Us=si,ur,_p,us=new Au,Cu={},vx=0,Qn=new bl(()=>{let i=new WebSocket(location.origin.replace(/^http/,"ws")+"/",Kp);return i.binaryType="arraybuffer",i},{serverInfo:i=>{Cu=i.metadata},ready:()=>{us.unsent&&bp()},closed:i=>{vx=performance.now()+i,us.disconnected(),ds.lose("the connection to the daemon is lost")},status:(i,e)=>{i>0&&$o.say(e,performance.now())},parameters:()=>{}});function yx(){Yo.forget(),ul.forget(),us.press(performance.now()),Qn.ready?bp():Qn.retryNow(),Mp.show(us.view(performance.now()))}function bp(){us.sent(),Qn.call("stop").then(i=>{let e=i,t=typeof e?.acknowledged_ms=="number"?e.acknowledged_ms:null;us.answered(e?.acknowledged===!0,t)},()=>{us.disconnected(),setTimeout(()=>{us.unsent&&Qn.ready&&bp()},$T)})}async function eA(i,e){_p?.abort();let t=_p=new AbortController;kr.loading(e,0);try{let n=await dx(i,s=>{kr.loading(e,s)},t.signal);ur=new Su(n,new oa(()=>0)),kr.open(e,ur),bx(ur.store),ur.playing=!0}catch(n){if(t.signal.aborted)return;Sp(),$o.say(n instanceof Error?n.message:String(n),performance.now())}}function Sp(){_p?.abort(),ur=void 0,kr.close(),bx(si)}function bx(i){Us=i,document.body.classList.toggle("replaying",i!==si),Pu.window_s=ur===void 0?QT:Math.min(Math.max(ur.duration_s,20),ju),dr.reset(),Ep.reset(),Tp.reset()}function px(i,e={}){Qn.call(i,e).catch(t=>{$o.say(t instanceof Error?t.message:String(t),performance.now())})}function xp(){return Cu.commands!=="stop"}function tA(i){i&&(Sp(),dr.set("map")),Ap.show(i),Ru.drawing(i)}var Mp=new lc(yx),Yo=new Ml(px,i=>{px("start",{from:i})}),wp=new xl(()=>navigator.getGamepads(),()=>performance.now()),ds=new gl((i,e)=>Qn.call(i,e),wp,()=>document.visibilityState==="visible"&&document.hasFocus(),i=>{i!==""&&$o.say(`Driving by hand: ${i}`,performance.now())}),ul=new Dl(ds,wp),Sx=new ac,$o=new zl,dr=new bu,Ep=new cc,Mx=new Vl,Pu=new rc,Tp=new Ol,mx=new Fl,vp=new oc((i,e)=>{eA(i.url,e.run)}),kr=new hc(Sp),gx=new Gl((i,e)=>{Qn.setParameter(i,e)}),_x=new Bl,Ru=new Ll(i=>Qn.call(i.name,i.request),tA),Ap=new Hl(i=>dr.world(i),()=>si.pose?.yaw_rad??0,i=>{Ap.show(!1),Ru.placed(i)}),Cp=new Nl([{id:"events",title:"Events",element:mx.element,show:()=>{mx.show(Us)}},{id:"courses",title:"Courses",element:Ru.element,show:()=>{Ru.show(si,Qn.ready,xp())}},{id:"runs",title:"Runs",element:vp.element,show:()=>{vp.show()}},{id:"parameters",title:"Parameters",element:gx.element,show:()=>{gx.show(si)}},{id:"link",title:"Link",element:_x.element,show:()=>{_x.show(Us)}},{id:"keys",title:"Keys",element:gm(),show:()=>{}}]),yp=G("span",{class:"badge"}),wx=G("span",{class:"setting"}),nA=G("header",{class:"bar"},G("div",{class:"identity"},G("h1",{},"TP100"),wx,yp),Sx.element,Yo.element,Mp.element);Pu.element.append(Tp.element);Yo.element.append(ul.button);dr.element.append(Ap.element,ul.element,$o.element,kr.element,Ep.element);document.body.append(nA,G("main",{},dr.element,Mx.element,Pu.element,Cp.element));for(let i of YT)Qn.subscribe(i,e=>{si.receive(i,e),i==="/state"?(us.received(e.stop),ds.received(e)):i==="/recording"?vp.changed():i==="/path_history"&&Qn.unsubscribe(i)});fx({stop:yx,start:()=>{Yo.pressStart()},hold:()=>{Yo.pressHold()},drive:()=>{ul.press()},driveKey:(i,e)=>iA(i,e),camera:i=>{dr.set(yu[i]??"free")},nextCamera:()=>{dr.next()},keys:()=>{Cp.select("keys")},step:i=>{kr.step(i)}});function iA(i,e){if(!ds.drives&&e)return!1;let t=wp.key(i,e)&&ds.drives;return t&&ds.tick(),t}setInterval(()=>{ds.tick()},40);for(let i of["blur","pagehide"])window.addEventListener(i,()=>{ds.leave()});document.addEventListener("visibilitychange",()=>{document.visibilityState!=="visible"&&ds.leave()});window.addEventListener("gamepaddisconnected",()=>{ds.tick()});function sA(i){return i==="simulated"?"simulated inside the board":i??""}function rA(){let i=si.get("/state"),e=[i?.robot??Cu.robot,i?.setup??Cu.setup].filter(Boolean);et(wx,e.join(" · "));let t=i===void 0?"TP100":`${i.run} · TP100`;document.title!==t&&(document.title=t);let n=si.get("/link")?.kind;et(yp,sA(n)),yt(yp,"data-kind",n??"")}var xx=performance.now(),hr={view:0,numbers:0,plots:0,chips:0};function Ex(i){if(Mp.show(us.view(performance.now())),i>=hr.view){hr.view=i+KT;let e=Math.min((i-xx)/1e3,.5);xx=i,ur?.tick(e),dr.draw(Us,e)}i>=hr.numbers&&(hr.numbers=i+ZT,Mx.show(Us),Ep.show(Us),kr.show()),i>=hr.plots&&(hr.plots=i+JT,Pu.show(Us)),i>=hr.chips&&(hr.chips=i+jT,Sx.show(si,Qn.ready),Yo.show(si,Qn.ready,xp()),ul.show(si,Qn.ready,xp()),$o.show(si,Qn.ready,(vx-i)/1e3,i,Us!==si),Tp.show(Us),Cp.show(),rA()),requestAnimationFrame(Ex)}requestAnimationFrame(Ex);
