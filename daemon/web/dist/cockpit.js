var Mw=Object.create;var r0=Object.defineProperty;var Tw=Object.getOwnPropertyDescriptor;var Ew=Object.getOwnPropertyNames;var Aw=Object.getPrototypeOf,Cw=Object.prototype.hasOwnProperty;var kn=(i,e)=>()=>{try{return e||i((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var Pw=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of Ew(e))!Cw.call(i,s)&&s!==t&&r0(i,s,{get:()=>e[s],enumerable:!(n=Tw(e,s))||n.enumerable});return i};var Rw=(i,e,t)=>(t=i!=null?Mw(Aw(i)):{},Pw(e||!i||!i.__esModule?r0(t,"default",{value:i,enumerable:!0}):t,i));var pu=kn(ta=>{"use strict";Object.defineProperty(ta,"__esModule",{value:!0});ta.toKeyName=ta.last=void 0;function yA(i){var e;return(e=i[i.length-1])!==null&&e!==void 0?e:null}ta.last=yA;function xA(i){return i.type==="TOMLBare"?i.name:i.value}ta.toKeyName=xA});var Jp=kn(_u=>{"use strict";Object.defineProperty(_u,"__esModule",{value:!0});_u.getTOMLVer=void 0;var gu=class{constructor(e,t){this.major=e,this.minor=t}lt(e,t){return this.major<e||this.major===e&&this.minor<t}gte(e,t){return this.major>e||this.major===e&&this.minor>=t}},mu=new gu(1,0),Zp=new gu(1,1),bA=mu,wA={"1.0":mu,"1.0.0":mu,"1.1":Zp,"1.1.0":Zp,latest:mu,next:Zp};function SA(i){return wA[i||"latest"]||bA}_u.getTOMLVer=SA});var yu=kn(vu=>{"use strict";Object.defineProperty(vu,"__esModule",{value:!0});vu.ParseError=void 0;var gv={"unterminated-string":"Unterminated string constant","unterminated-table-key":"Unterminated table-key","unterminated-array":"Unterminated array","unterminated-inline-table":"Unterminated inline table","missing-key":"Empty bare keys are not allowed","missing-newline":"Must be a newline","missing-equals-sign":"Expected equal (=) token","missing-value":"Unspecified values are invalid","missing-comma":"Expected comma (,) token","dupe-keys":"Defining a key multiple times is invalid","unexpected-char":"Unexpected character","unexpected-token":"Unexpected token","invalid-control-character":"Control characters (codes < 0x1f and 0x7f) are not allowed","invalid-comment-character":"Invalid code point {{cp}} within comments","invalid-key-value-newline":"The key, equals sign, and value must be on the same line","invalid-inline-table-newline":"No newlines are allowed between the curly braces unless they are valid within a value","invalid-underscore":"Underscores are allowed between digits","invalid-space":"Unexpected spaces","invalid-three-quotes":"Three or more quotes are not permitted","invalid-date":"Unexpected invalid date","invalid-time":"Unexpected invalid time","invalid-leading-zero":"Leading zeros are not allowed","invalid-trailing-comma-in-inline-table":"Trailing comma is not permitted in an inline table","invalid-char-in-escape-sequence":"Invalid character in escape sequence","invalid-code-point":"Invalid code point {{cp}}"};function MA(i,e){return e?gv[i].replace(/\{\{(.*?)\}\}/gu,(t,n)=>n in e?e[n]:`{{${n}}}`):gv[i]}var jp=class extends SyntaxError{constructor(e,t,n,s,r){super(MA(e,r)),this.index=t,this.lineNumber=n,this.column=s}};vu.ParseError=jp});var _v=kn(xu=>{"use strict";Object.defineProperty(xu,"__esModule",{value:!0});xu.Locations=void 0;function TA(i,e){let t=0,n=i.length;for(;t<n;){let s=t+n>>>1,r=i[s];if(r===e)return s+1;r<e?t=s+1:n=s}return t}var Qp=class{constructor(){this.offsets=[]}addOffset(e){for(let t=this.offsets.length-1;t>=0;t--){let n=this.offsets[t];if(n===e)return;if(n<e)break}this.offsets.push(e)}getLocFromIndex(e){let t=TA(this.offsets,e)+1,n=e-(t===1?0:this.offsets[t-2]);return{line:t,column:n}}};xu.Locations=Qp});var vv=kn(bu=>{"use strict";Object.defineProperty(bu,"__esModule",{value:!0});bu.CodePointIterator=void 0;var EA=_v(),em=class{constructor(e){this.locs=new EA.Locations,this.lastCodePoint=0,this.start=-1,this.end=0,this.text=e}next(){return this.lastCodePoint===-1?-1:this.lastCodePoint=this.moveAt(this.end)}getStartLoc(){return this.getLocFromIndex(this.start)}getEndLoc(){return this.getLocFromIndex(this.end)}getLocFromIndex(e){return this.locs.getLocFromIndex(e)}eat(e){return this.text.codePointAt(this.end)===e?(this.next(),!0):!1}moveAt(e){var t;this.start=this.end=e;let n=(t=this.text.codePointAt(this.start))!==null&&t!==void 0?t:-1;if(n===-1)return this.end=this.start,n;let s=n>=65536?2:1;if(this.end+=s,n===10)this.locs.addOffset(this.end);else if(n===13)return this.text.codePointAt(this.end)===10&&(this.end++,this.locs.addOffset(this.end)),10;return n}};bu.CodePointIterator=em});var xv=kn(ln=>{"use strict";Object.defineProperty(ln,"__esModule",{value:!0});ln.isUnicodeScalarValue=ln.isLowSurrogate=ln.isHighSurrogate=ln.isOctalDig=ln.isHexDig=ln.isDigit=ln.isLetter=ln.isEOL=ln.isWhitespace=ln.isControl=void 0;function AA(i){return i>=0&&i<=31}ln.isControl=AA;function CA(i){return i===9||i===32}ln.isWhitespace=CA;function PA(i){return i===10||i===13}ln.isEOL=PA;function RA(i){return i>=65&&i<=90}function LA(i){return i>=97&&i<=122}function IA(i){return LA(i)||RA(i)}ln.isLetter=IA;function yv(i){return i>=48&&i<=57}ln.isDigit=yv;function DA(i){return yv(i)||i>=97&&i<=102||i>=65&&i<=70}ln.isHexDig=DA;function NA(i){return i>=48&&i<=55}ln.isOctalDig=NA;function kA(i){return i>=55296&&i<=57343}ln.isHighSurrogate=kA;function OA(i){return i>=56320&&i<=57343}ln.isLowSurrogate=OA;function UA(i){return i>=0&&i<=55295||i>=57344&&i<=1114111}ln.isUnicodeScalarValue=UA});var Sv=kn(wu=>{"use strict";Object.defineProperty(wu,"__esModule",{value:!0});wu.Tokenizer=void 0;var FA=yu(),BA=Jp(),zA=vv(),pt=xv(),VA=typeof BigInt<"u",GA={16:"0x",10:"",8:"0o",2:"0b"},wv={34:34,92:92,98:8,102:12,110:10,114:13,116:9},HA=Object.assign(Object.assign({},wv),{101:27}),nm=class{constructor(e,t){this.backCode=!1,this.lastCodePoint=0,this.state="DATA",this.token=null,this.tokenStart=-1,this.valuesEnabled=!1,this.text=e,this.parserOptions=t||{},this.codePointIterator=new zA.CodePointIterator(e),this.tomlVersion=(0,BA.getTOMLVer)(this.parserOptions.tomlVersion),this.ESCAPES=this.tomlVersion.gte(1,1)?HA:wv}get positions(){return{start:Object.assign(Object.assign({},this.codePointIterator.getStartLoc()),{offset:this.codePointIterator.start}),end:Object.assign(Object.assign({},this.codePointIterator.getEndLoc()),{offset:this.codePointIterator.end})}}reportParseError(e,t){let n=this.codePointIterator.getStartLoc();throw new FA.ParseError(e,this.codePointIterator.start,n.line,n.column,t)}nextToken(){let e=this.token;if(e!=null)return this.token=null,e;let t=this.lastCodePoint;for(;t!==-1&&!this.token;){t=this.nextCode();let n=this[this.state](t);if(!n)throw new Error(`Unknown error: pre state=${this.state}`);this.state=n}return e=this.token,this.token=null,e}nextCode(){return this.lastCodePoint===-1?-1:this.backCode?(this.backCode=!1,this.lastCodePoint):this.lastCodePoint=this.codePointIterator.next()}eatCode(e){return this.lastCodePoint===-1?!1:this.backCode?this.lastCodePoint===e?(this.backCode=!1,!0):!1:this.codePointIterator.eat(e)}moveAt(e){this.backCode&&(this.backCode=!1),this.lastCodePoint=this.codePointIterator.moveAt(e)}back(e){return this.backCode=!0,e}punctuatorToken(){this.startToken(),this.endToken("Punctuator","end")}startToken(){this.tokenStart=this.codePointIterator.start}endToken(e,t,n,s){let{tokenStart:r}=this,o=this.codePointIterator[t],a=[r,o],l={start:this.codePointIterator.getLocFromIndex(r),end:this.codePointIterator.getLocFromIndex(o)};if(e==="Block")this.token={type:e,value:this.text.slice(r+1,o),range:a,loc:l};else{let c,h=this.text.slice(r,o);if(e==="BasicString"||e==="LiteralString"||e==="MultiLineBasicString"||e==="MultiLineLiteralString")c={type:e,value:h,string:n,range:a,loc:l};else if(e==="Integer"){let u=n;c={type:e,value:h,number:parseInt(u,s),bigint:VA?BigInt(GA[s]+u):null,range:a,loc:l}}else e==="Float"?c={type:e,value:h,number:n,range:a,loc:l}:e==="Boolean"?c={type:e,value:h,boolean:n,range:a,loc:l}:e==="LocalDate"||e==="LocalTime"||e==="LocalDateTime"||e==="OffsetDateTime"?c={type:e,value:h,date:n,range:a,loc:l}:c={type:e,value:h,range:a,loc:l};this.token=c}}DATA(e){for(;(0,pt.isWhitespace)(e)||(0,pt.isEOL)(e);)e=this.nextCode();if(e===35)return this.startToken(),"COMMENT";if(e===34)return this.startToken(),"BASIC_STRING";if(e===39)return this.startToken(),"LITERAL_STRING";if(e===46||e===61||e===91||e===93||e===123||e===125||e===44)return this.punctuatorToken(),"DATA";if(this.valuesEnabled){if(e===45||e===43)return this.startToken(),"SIGN";if(e===110||e===105)return this.startToken(),this.back("NAN_OR_INF");if((0,pt.isDigit)(e))return this.startToken(),this.back("NUMBER");if(e===116||e===102)return this.startToken(),this.back("BOOLEAN")}else if(bv(e,this.tomlVersion))return this.startToken(),"BARE";return e===-1?"DATA":this.reportParseError("unexpected-char")}COMMENT(e){let t=this.tomlVersion.gte(1,1)?n=>{WA(n)||this.reportParseError("invalid-comment-character")}:n=>{Cl(n)&&this.reportParseErrorControlChar()};for(;!(0,pt.isEOL)(e)&&e!==-1;)t(e),e=this.nextCode();return this.endToken("Block","start"),"DATA"}BARE(e){for(;bv(e,this.tomlVersion);)e=this.nextCode();return this.endToken("Bare","start"),this.back("DATA")}BASIC_STRING(e){if(e===34)return e=this.nextCode(),e===34?"MULTI_LINE_BASIC_STRING":(this.endToken("BasicString","start",""),this.back("DATA"));let t=[];for(;e!==34&&e!==-1&&e!==10;){if(Cl(e))return this.reportParseErrorControlChar();if(e===92){e=this.nextCode();let n=this.ESCAPES[e];if(n){t.push(n),e=this.nextCode();continue}else if(e===117){let s=this.parseUnicode(4);t.push(s),e=this.nextCode();continue}else if(e===85){let s=this.parseUnicode(8);t.push(s),e=this.nextCode();continue}else if(e===120&&this.tomlVersion.gte(1,1)){let s=this.parseUnicode(2);t.push(s),e=this.nextCode();continue}return this.reportParseError("invalid-char-in-escape-sequence")}t.push(e),e=this.nextCode()}return e!==34?this.reportParseError("unterminated-string"):(this.endToken("BasicString","end",String.fromCodePoint(...t)),"DATA")}MULTI_LINE_BASIC_STRING(e){let t=[];for(e===10&&(e=this.nextCode());e!==-1;){if(e!==10&&Cl(e))return this.reportParseErrorControlChar();if(e===34){let n=this.codePointIterator.start;if(this.eatCode(34)&&this.eatCode(34))return this.eatCode(34)&&(t.push(34),this.eatCode(34)&&(t.push(34),this.eatCode(34)))?(this.moveAt(n),this.reportParseError("invalid-three-quotes")):(this.endToken("MultiLineBasicString","end",String.fromCodePoint(...t)),"DATA");this.moveAt(n)}if(e===92){e=this.nextCode();let n=this.ESCAPES[e];if(n){t.push(n),e=this.nextCode();continue}else if(e===117){let s=this.parseUnicode(4);t.push(s),e=this.nextCode();continue}else if(e===85){let s=this.parseUnicode(8);t.push(s),e=this.nextCode();continue}else if(e===120&&this.tomlVersion.gte(1,1)){let s=this.parseUnicode(2);t.push(s),e=this.nextCode();continue}else if(e===10){for(e=this.nextCode();(0,pt.isWhitespace)(e)||e===10;)e=this.nextCode();continue}else if((0,pt.isWhitespace)(e)){let s=!0,r=this.codePointIterator.start,o;for(;(o=this.nextCode())!==-1&&o!==10;)if(!(0,pt.isWhitespace)(o)){this.moveAt(r),s=!1;break}if(s){for(e=this.nextCode();(0,pt.isWhitespace)(e)||e===10;)e=this.nextCode();continue}}return this.reportParseError("invalid-char-in-escape-sequence")}t.push(e),e=this.nextCode()}return this.reportParseError("unterminated-string")}LITERAL_STRING(e){if(e===39)return e=this.nextCode(),e===39?"MULTI_LINE_LITERAL_STRING":(this.endToken("LiteralString","start",""),this.back("DATA"));let t=[];for(;e!==39&&e!==-1&&e!==10;){if(Cl(e))return this.reportParseErrorControlChar();t.push(e),e=this.nextCode()}return e!==39?this.reportParseError("unterminated-string"):(this.endToken("LiteralString","end",String.fromCodePoint(...t)),"DATA")}MULTI_LINE_LITERAL_STRING(e){let t=[];for(e===10&&(e=this.nextCode());e!==-1;){if(e!==10&&Cl(e))return this.reportParseErrorControlChar();if(e===39){let n=this.codePointIterator.start;if(this.eatCode(39)&&this.eatCode(39))return this.eatCode(39)&&(t.push(39),this.eatCode(39)&&(t.push(39),this.eatCode(39)))?(this.moveAt(n),this.reportParseError("invalid-three-quotes")):(this.endToken("MultiLineLiteralString","end",String.fromCodePoint(...t)),"DATA");this.moveAt(n)}t.push(e),e=this.nextCode()}return this.reportParseError("unterminated-string")}SIGN(e){return e===110||e===105?this.back("NAN_OR_INF"):(0,pt.isDigit)(e)?this.back("NUMBER"):this.reportParseError("unexpected-char")}NAN_OR_INF(e){if(e===110){let t=this.codePointIterator.start;if(this.eatCode(97)&&this.eatCode(110))return this.endToken("Float","end",NaN),"DATA";this.moveAt(t)}else if(e===105){let t=this.codePointIterator.start;if(this.eatCode(110)&&this.eatCode(102))return this.endToken("Float","end",this.text[this.tokenStart]==="-"?-1/0:1/0),"DATA";this.moveAt(t)}return this.reportParseError("unexpected-char")}NUMBER(e){let t=this.text[this.tokenStart],n=t==="+"?43:t==="-"?45:0;if(e===48){if(n===0){let a=this.codePointIterator.start,l=this.nextCode();if((0,pt.isDigit)(l)){let c=this.nextCode();if(c===58){let h={hasDate:!1,year:0,month:0,day:0,hour:Number(String.fromCodePoint(48,l)),minute:0,second:0};return this.data=h,"TIME_MINUTE"}if((0,pt.isDigit)(c)){let h=this.nextCode();if((0,pt.isDigit)(h)&&this.eatCode(45)){let u={hasDate:!0,year:Number(String.fromCodePoint(48,l,c,h)),month:0,day:0,hour:0,minute:0,second:0};return this.data=u,"DATE_MONTH"}}return this.moveAt(a),this.reportParseError("invalid-leading-zero")}this.moveAt(a)}if(e=this.nextCode(),e===120||e===111||e===98)return n!==0?this.reportParseError("unexpected-char"):e===120?"HEX":e===111?"OCTAL":"BINARY";if(e===101||e===69){let a={minus:n===45,left:[48]};return this.data=a,"EXPONENT_RIGHT"}if(e===46){let a={minus:n===45,absInt:[48]};return this.data=a,"FRACTIONAL_RIGHT"}return this.endToken("Integer","start","0",10),this.back("DATA")}let{out:s,nextCp:r,hasUnderscore:o}=this.parseDigits(e,pt.isDigit);if(r===45&&n===0&&!o&&s.length===4){let a={hasDate:!0,year:Number(String.fromCodePoint(...s)),month:0,day:0,hour:0,minute:0,second:0};return this.data=a,"DATE_MONTH"}if(r===58&&n===0&&!o&&s.length===2){let a={hasDate:!1,year:0,month:0,day:0,hour:Number(String.fromCodePoint(...s)),minute:0,second:0};return this.data=a,"TIME_MINUTE"}if(r===101||r===69){let a={minus:n===45,left:s};return this.data=a,"EXPONENT_RIGHT"}if(r===46){let a={minus:n===45,absInt:s};return this.data=a,"FRACTIONAL_RIGHT"}return this.endToken("Integer","start",n===45?String.fromCodePoint(45,...s):String.fromCodePoint(...s),10),this.back("DATA")}HEX(e){let{out:t}=this.parseDigits(e,pt.isHexDig);return this.endToken("Integer","start",String.fromCodePoint(...t),16),this.back("DATA")}OCTAL(e){let{out:t}=this.parseDigits(e,pt.isOctalDig);return this.endToken("Integer","start",String.fromCodePoint(...t),8),this.back("DATA")}BINARY(e){let{out:t}=this.parseDigits(e,n=>n===48||n===49);return this.endToken("Integer","start",String.fromCodePoint(...t),2),this.back("DATA")}FRACTIONAL_RIGHT(e){let{minus:t,absInt:n}=this.data,{out:s,nextCp:r}=this.parseDigits(e,pt.isDigit),o=[...n,46,...s];if(r===101||r===69){let l={minus:t,left:o};return this.data=l,"EXPONENT_RIGHT"}let a=Number(t?String.fromCodePoint(45,...o):String.fromCodePoint(...o));return this.endToken("Float","start",a),this.back("DATA")}EXPONENT_RIGHT(e){let{left:t,minus:n}=this.data,s=!1;(e===45||e===43)&&(s=e===45,e=this.nextCode());let{out:r}=this.parseDigits(e,pt.isDigit),o=r;s&&o.unshift(45);let a=Number(n?String.fromCodePoint(45,...t,101,...o):String.fromCodePoint(...t,101,...o));return this.endToken("Float","start",a),this.back("DATA")}BOOLEAN(e){if(e===116){let t=this.codePointIterator.start;if(this.eatCode(114)&&this.eatCode(117)&&this.eatCode(101))return this.endToken("Boolean","end",!0),"DATA";this.moveAt(t)}else if(e===102){let t=this.codePointIterator.start;if(this.eatCode(97)&&this.eatCode(108)&&this.eatCode(115)&&this.eatCode(101))return this.endToken("Boolean","end",!1),"DATA";this.moveAt(t)}return this.reportParseError("unexpected-char")}DATE_MONTH(e){let t=this.codePointIterator.start;if(!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),e!==45)return this.reportParseError("unexpected-char");let n=this.codePointIterator.start,s=this.data;return s.month=Number(this.text.slice(t,n)),"DATE_DAY"}DATE_DAY(e){let t=this.codePointIterator.start;if(!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");let n=this.codePointIterator.end,s=this.data;if(s.day=Number(this.text.slice(t,n)),!qA(s.year,s.month,s.day))return this.reportParseError("invalid-date");if(e=this.nextCode(),e===84||e===116)return"TIME_HOUR";if(e===32){let o=this.codePointIterator.start;if((0,pt.isDigit)(this.nextCode())&&(0,pt.isDigit)(this.nextCode()))return this.moveAt(o),"TIME_HOUR";this.moveAt(o)}let r=Pl(s,"");return this.endToken("LocalDate","start",r),this.back("DATA")}TIME_HOUR(e){let t=this.codePointIterator.start;if(!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),e!==58)return this.reportParseError("unexpected-char");let n=this.codePointIterator.start,s=this.data;return s.hour=Number(this.text.slice(t,n)),"TIME_MINUTE"}TIME_MINUTE(e){let t=this.codePointIterator.start;if(!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");let n=this.codePointIterator.end,s=this.data;return s.minute=Number(this.text.slice(t,n)),e=this.nextCode(),e===58?"TIME_SECOND":this.tomlVersion.lt(1,1)?this.reportParseError("unexpected-char"):tm(s.hour,s.minute,s.second)?this.processTimeEnd(e,s):this.reportParseError("invalid-time")}TIME_SECOND(e){let t=this.codePointIterator.start;if(!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");let n=this.codePointIterator.end,s=this.data;return s.second=Number(this.text.slice(t,n)),tm(s.hour,s.minute,s.second)?(e=this.nextCode(),e===46?"TIME_SEC_FRAC":this.processTimeEnd(e,s)):this.reportParseError("invalid-time")}TIME_SEC_FRAC(e){if(!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");let t=this.codePointIterator.start;for(;(0,pt.isDigit)(e);)e=this.nextCode();let n=this.codePointIterator.start,s=this.data;return s.frac=this.text.slice(t,n),this.processTimeEnd(e,s)}processTimeEnd(e,t){if(t.hasDate){if(e===45||e===43)return t.offsetSign=e,"TIME_OFFSET";if(e===90||e===122){let r=Pl(t,"Z");return this.endToken("OffsetDateTime","end",r),"DATA"}let s=Pl(t,"");return this.endToken("LocalDateTime","start",s),this.back("DATA")}let n=Pl(t,"");return this.endToken("LocalTime","start",n),this.back("DATA")}TIME_OFFSET(e){if(!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");let t=this.codePointIterator.start;if(e=this.nextCode(),!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),e!==58)return this.reportParseError("unexpected-char");let n=this.codePointIterator.start;e=this.nextCode();let s=this.codePointIterator.start;if(!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),!(0,pt.isDigit)(e))return this.reportParseError("unexpected-char");let r=this.codePointIterator.end,o=Number(this.text.slice(t,n)),a=Number(this.text.slice(s,r));if(!tm(o,a,0))return this.reportParseError("invalid-time");let l=this.data,c=Pl(l,`${String.fromCodePoint(l.offsetSign)}${xr(o,2)}:${xr(a,2)}`);return this.endToken("OffsetDateTime","end",c),"DATA"}parseDigits(e,t){if(e===95)return this.reportParseError("invalid-underscore");if(!t(e))return this.reportParseError("unexpected-char");let n=[],s=0,r=!1;for(;t(e)||e===95;){if(e===95){if(r=!0,s===95)return this.reportParseError("invalid-underscore")}else n.push(e);s=e,e=this.nextCode()}return s===95?this.reportParseError("invalid-underscore"):{out:n,nextCp:e,hasUnderscore:r}}parseUnicode(e){let t=this.codePointIterator.start,n=this.codePointIterator.end,s=0,r;for(;(r=this.nextCode())!==-1;){if(!(0,pt.isHexDig)(r))return this.moveAt(t),this.reportParseError("invalid-char-in-escape-sequence");if(s++,s>=e)break}let o=this.codePointIterator.end,a=this.text.slice(n,o),l=parseInt(a,16);return(0,pt.isUnicodeScalarValue)(l)?l:this.reportParseError("invalid-code-point",{cp:a})}reportParseErrorControlChar(){return this.reportParseError("invalid-control-character")}};wu.Tokenizer=nm;function bv(i,e){return(0,pt.isLetter)(i)||(0,pt.isDigit)(i)||i===95||i===45?!0:e.lt(1,1)?!1:i===178||i===179||i===185||188<=i&&i<=190||192<=i&&i<=214||216<=i&&i<=246||248<=i&&i<=891||895<=i&&i<=8191||8204<=i&&i<=8205||8255<=i&&i<=8256||8304<=i&&i<=8591||9312<=i&&i<=9471||11264<=i&&i<=12271||12289<=i&&i<=55295||63744<=i&&i<=64975||65008<=i&&i<=65533||65536<=i&&i<=983039}function Cl(i){return(0,pt.isControl)(i)&&i!==9||i===127}function WA(i){return 1<=i&&i<=9||14<=i&&i<=127||XA(i)}function XA(i){return 128<=i&&i<=55295||57344<=i&&i<=1114111}function qA(i,e,t){if(i>=0&&e<=12&&e>=1&&t>=1){let n=e===2?i&3||!(i%25)&&i&15?28:29:30+(e+(e>>3)&1);return t<=n}return!1}function tm(i,e,t){return!(i>=24||i<0||e>59||e<0||t>60||t<0)}function Pl(i,e){let t=xr(i.year,4),n=i.month?xr(i.month,2):"01",s=i.day?xr(i.day,2):"01",r=xr(i.hour,2),o=xr(i.minute,2),a=xr(i.second,2),l=`${t}-${n}-${s}`,c=i.frac?`.${i.frac}`:"",h=new Date(`${l}T${r}:${o}:${a}${c}${e}`);return!isNaN(h.getTime())||i.second!==60?h:new Date(`${l}T${r}:${o}:59${c}${e}`)}function xr(i,e){return String(i).padStart(e,"0")}});var Mv=kn(Xr=>{"use strict";var $A=Xr&&Xr.__createBinding||(Object.create?(function(i,e,t,n){n===void 0&&(n=t);var s=Object.getOwnPropertyDescriptor(e,t);(!s||("get"in s?!e.__esModule:s.writable||s.configurable))&&(s={enumerable:!0,get:function(){return e[t]}}),Object.defineProperty(i,n,s)}):(function(i,e,t,n){n===void 0&&(n=t),i[n]=e[t]})),YA=Xr&&Xr.__exportStar||function(i,e){for(var t in i)t!=="default"&&!Object.prototype.hasOwnProperty.call(e,t)&&$A(e,i,t)};Object.defineProperty(Xr,"__esModule",{value:!0});YA(Sv(),Xr)});var Av=kn(Tu=>{"use strict";Object.defineProperty(Tu,"__esModule",{value:!0});Tu.KeysResolver=void 0;var Mu=pu(),im=class{constructor(e){this.rootKeys=new Map,this.tables=[],this.ctx=e}applyResolveKeyForTable(e){let t=this.rootKeys,n=e.key.keys.length-1;for(let a=0;a<n;a++){let l=e.key.keys[a],c=(0,Mu.toKeyName)(l);e.resolvedKey.push(c);let h=t.get(c);if(!h)h={node:l,keys:new Map},t.set(c,h);else if(h.table==="array"){let u=h.peekIndex;e.resolvedKey.push(u),h=h.keys.get(u)}t=h.keys}let s=e.key.keys[n],r=(0,Mu.toKeyName)(s);e.resolvedKey.push(r);let o=t.get(r);if(o)if(o.table)if(o.table==="array")if(e.kind==="array"){let a={node:s,keys:new Map},l=o.peekIndex+1;e.resolvedKey.push(l),o.keys.set(l,a),o.peekIndex=l,this.tables.push({node:e,keys:a.keys})}else this.ctx.reportParseError("dupe-keys",s);else this.ctx.reportParseError("dupe-keys",s);else if(e.kind==="array")this.ctx.reportParseError("dupe-keys",s);else{let a={table:e.kind,node:s,keys:o.keys};t.set(r,a),this.tables.push({node:e,keys:a.keys})}else if(e.kind==="array"){e.resolvedKey.push(0);let a={node:s,keys:new Map};t.set(r,{table:e.kind,node:s,keys:new Map([[0,a]]),peekIndex:0}),this.tables.push({node:e,keys:a.keys})}else{let a={table:e.kind,node:s,keys:new Map};t.set(r,a),this.tables.push({node:e,keys:a.keys})}}verifyDuplicateKeys(e){for(let t of e.body)t.type==="TOMLKeyValue"&&sm(this.ctx,this.rootKeys,t);for(let{node:t,keys:n}of this.tables)for(let s of t.body)sm(this.ctx,n,s)}};Tu.KeysResolver=im;function sm(i,e,t){let n=e,s=(0,Mu.last)(t.key.keys);for(let r of t.key.keys){let o=(0,Mu.toKeyName)(r),a=n.get(o);a?((a.value===0||s===r||a.table)&&i.reportParseError("dupe-keys",Su(r,a.node)),a.value=1):(s===r?a={value:0,node:r,keys:new Map}:a={value:1,node:r,keys:new Map},n.set(o,a)),n=a.keys}t.value.type==="TOMLInlineTable"?Tv(i,n,t.value):t.value.type==="TOMLArray"&&Ev(i,n,t.value)}function Tv(i,e,t){for(let n of t.body)sm(i,e,n)}function Ev(i,e,t){let n=e;for(let s=0;s<t.elements.length;s++){let r=t.elements[s],o=n.get(s);o?i.reportParseError("dupe-keys",Su(r,o.node)):(o={value:0,node:r,keys:new Map},e.set(s,o),r.type==="TOMLInlineTable"?Tv(i,o.keys,r):r.type==="TOMLArray"&&Ev(i,o.keys,r))}}function Su(i,e){return i.range[0]<=e.range[0]?e:i}});var Cv=kn(Eu=>{"use strict";Object.defineProperty(Eu,"__esModule",{value:!0});Eu.Context=void 0;var KA=yu(),ZA=Mv(),JA=Av(),rm=class{constructor(e){this.tokens=[],this.comments=[],this.back=null,this.stateStack=[],this.needNewLine=!1,this.needSameLine=!1,this.currToken=null,this.prevToken=null,this.valueContainerStack=[],this.tokenizer=new ZA.Tokenizer(e.text,e.parserOptions),this.topLevelTable=e.topLevelTable,this.table=e.topLevelTable,this.keysResolver=new JA.KeysResolver(this)}get startPos(){return this.tokenizer.positions.start}get endPos(){return this.tokenizer.positions.end}nextToken(e){if(this.prevToken=this.currToken,this.back?(this.currToken=this.back,this.back=null):this.currToken=this._nextTokenFromTokenizer(e),(this.needNewLine||this.needSameLine||e?.needSameLine)&&this.prevToken&&this.currToken)if(this.prevToken.loc.end.line===this.currToken.loc.start.line){if(this.needNewLine)return this.reportParseError("missing-newline",this.currToken)}else{let t=this.needSameLine||e?.needSameLine;if(t)return this.reportParseError(t,this.currToken)}return this.needNewLine=!1,this.needSameLine=!1,this.currToken}_nextTokenFromTokenizer(e){let t=this.tokenizer.valuesEnabled;e?.valuesEnabled&&(this.tokenizer.valuesEnabled=e.valuesEnabled);let n=this.tokenizer.nextToken();for(;n&&n.type==="Block";)this.comments.push(n),n=this.tokenizer.nextToken();return n&&this.tokens.push(n),this.tokenizer.valuesEnabled=t,n}backToken(){if(this.back)throw new Error("Illegal state");this.back=this.currToken,this.currToken=this.prevToken}addValueContainer(e){this.valueContainerStack.push(e),this.tokenizer.valuesEnabled=!0}consumeValueContainer(){let e=this.valueContainerStack.pop();return this.tokenizer.valuesEnabled=this.valueContainerStack.length>0,e}applyResolveKeyForTable(e){this.keysResolver.applyResolveKeyForTable(e)}verifyDuplicateKeys(){this.keysResolver.verifyDuplicateKeys(this.topLevelTable)}reportParseError(e,t){let n,s,r;if(t)n=t.range[0],s=t.loc.start.line,r=t.loc.start.column;else{let o=this.startPos;n=o.offset,s=o.line,r=o.column}throw new KA.ParseError(e,n,s,r)}};Eu.Context=rm});var Dv=kn(Ru=>{"use strict";Object.defineProperty(Ru,"__esModule",{value:!0});Ru.TOMLParser=void 0;var Au=pu(),jA=Jp(),QA=Cv(),Pv={VALUE:"missing-value"},eC={BasicString:"basic",MultiLineBasicString:"basic",LiteralString:"literal",MultiLineLiteralString:"literal"},tC={BasicString:"basic",LiteralString:"literal"},nC={OffsetDateTime:"offset-date-time",LocalDateTime:"local-date-time",LocalDate:"local-date",LocalTime:"local-time"},lm=class{constructor(e,t){this.text=e,this.parserOptions=t||{},this.tomlVersion=(0,jA.getTOMLVer)(this.parserOptions.tomlVersion)}parse(){let e={type:"Program",body:[],sourceType:"module",tokens:[],comments:[],parent:null,range:[0,0],loc:{start:{line:1,column:0},end:{line:1,column:0}}},t={type:"TOMLTopLevelTable",body:[],parent:e,range:ci(e.range),loc:hi(e.loc)};e.body=[t];let n=new QA.Context({text:this.text,parserOptions:this.parserOptions,topLevelTable:t}),s=n.nextToken();if(s){for(t.range[0]=s.range[0],t.loc.start=Pu(s.loc.start);s;){let a=n.stateStack.pop()||"TABLE";n.stateStack.push(...this[a](s,n)),s=n.nextToken()}let o=n.stateStack.pop()||"TABLE";if(o in Pv)return n.reportParseError(Pv[o],null);n.table.type==="TOMLTable"&&Ki(n.table,(0,Au.last)(n.table.body)),Ki(t,(0,Au.last)(t.body))}n.verifyDuplicateKeys(),e.tokens=n.tokens,e.comments=n.comments;let r=n.endPos;return e.range[1]=r.offset,e.loc.end={line:r.line,column:r.column},e}TABLE(e,t){return Cu(e)||Ll(e)?this.processKeyValue(e,t.table,t):om(e)?this.processTable(e,t.topLevelTable,t):t.reportParseError("unexpected-token",e)}VALUE(e,t){return Ll(e)||Iv(e)?this.processStringValue(e,t):rC(e)?this.processNumberValue(e,t):oC(e)?this.processBooleanValue(e,t):aC(e)?this.processDateTimeValue(e,t):om(e)?this.processArray(e,t):sC(e)?this.processInlineTable(e,t):t.reportParseError("unexpected-token",e)}processTable(e,t,n){let s={type:"TOMLTable",kind:"standard",key:null,resolvedKey:[],body:[],parent:t,range:ci(e.range),loc:hi(e.loc)};n.table.type==="TOMLTable"&&Ki(n.table,(0,Au.last)(n.table.body)),t.body.push(s),n.table=s;let r=n.nextToken({needSameLine:"invalid-key-value-newline"});if(om(r)){if(e.range[1]<r.range[0])return n.reportParseError("invalid-space",r);s.kind="array",r=n.nextToken({needSameLine:"invalid-key-value-newline"})}if(Rl(r))return n.reportParseError("missing-key",r);if(!r)return n.reportParseError("unterminated-table-key",null);if(r=this.processKeyNode(r,s,n).nextToken,!Rl(r))return n.reportParseError("unterminated-table-key",r);if(s.kind==="array"){let a=r;if(r=n.nextToken({needSameLine:"invalid-key-value-newline"}),!Rl(r))return n.reportParseError("unterminated-table-key",r);if(a.range[1]<r.range[0])return n.reportParseError("invalid-space",r)}return Ki(s,r),n.applyResolveKeyForTable(s),n.needNewLine=!0,[]}processKeyValue(e,t,n){let s={type:"TOMLKeyValue",key:null,value:null,parent:t,range:ci(e.range),loc:hi(e.loc)};t.body.push(s);let{nextToken:r}=this.processKeyNode(e,s,n);return Rv(r)?(n.addValueContainer({parent:s,set:o=>(s.value=o,Ki(s,o),n.needNewLine=!0,[])}),n.needSameLine="invalid-key-value-newline",["VALUE"]):n.reportParseError("missing-equals-sign",r)}processKeyNode(e,t,n){let s={type:"TOMLKey",keys:[],parent:t,range:ci(e.range),loc:hi(e.loc)};t.key=s;let r=e;for(;r;){if(Cu(r))this.processBareKey(r,s);else if(Ll(r))this.processStringKey(r,s);else break;if(r=n.nextToken({needSameLine:"invalid-key-value-newline"}),iC(r))r=n.nextToken({needSameLine:"invalid-key-value-newline"});else break}return Ki(s,(0,Au.last)(s.keys)),{keyNode:s,nextToken:r}}processBareKey(e,t){let n={type:"TOMLBare",name:e.value,parent:t,range:ci(e.range),loc:hi(e.loc)};t.keys.push(n)}processStringKey(e,t){let n={type:"TOMLQuoted",kind:"string",value:e.string,style:tC[e.type],multiline:!1,parent:t,range:ci(e.range),loc:hi(e.loc)};t.keys.push(n)}processStringValue(e,t){let n=t.consumeValueContainer(),s={type:"TOMLValue",kind:"string",value:e.string,style:eC[e.type],multiline:Iv(e),parent:n.parent,range:ci(e.range),loc:hi(e.loc)};return n.set(s)}processNumberValue(e,t){let n=t.consumeValueContainer(),s=this.text,[r,o]=e.range,a=null,l=()=>a??(a=s.slice(r,o).replace(/_/g,"")),c;return e.type==="Integer"?c={type:"TOMLValue",kind:"integer",value:e.number,bigint:e.bigint,get number(){return l()},parent:n.parent,range:ci(e.range),loc:hi(e.loc)}:c={type:"TOMLValue",kind:"float",value:e.number,get number(){return l()},parent:n.parent,range:ci(e.range),loc:hi(e.loc)},n.set(c)}processBooleanValue(e,t){let n=t.consumeValueContainer(),s={type:"TOMLValue",kind:"boolean",value:e.boolean,parent:n.parent,range:ci(e.range),loc:hi(e.loc)};return n.set(s)}processDateTimeValue(e,t){let n=t.consumeValueContainer(),s={type:"TOMLValue",kind:nC[e.type],value:e.date,datetime:e.value,parent:n.parent,range:ci(e.range),loc:hi(e.loc)};return n.set(s)}processArray(e,t){let n=t.consumeValueContainer(),s={type:"TOMLArray",elements:[],parent:n.parent,range:ci(e.range),loc:hi(e.loc)},r=t.nextToken({valuesEnabled:!0});return Rl(r)?(Ki(s,r),n.set(s)):(t.backToken(),this.processArrayValue(s,n,t))}processArrayValue(e,t,n){return n.addValueContainer({parent:e,set:s=>{e.elements.push(s);let r=n.nextToken({valuesEnabled:!0}),o=Lv(r);return o&&(r=n.nextToken({valuesEnabled:!0})),Rl(r)?(Ki(e,r),t.set(e)):o?(n.backToken(),this.processArrayValue(e,t,n)):n.reportParseError(r?"missing-comma":"unterminated-array",r)}}),["VALUE"]}processInlineTable(e,t){let n=t.consumeValueContainer(),s={type:"TOMLInlineTable",body:[],parent:n.parent,range:ci(e.range),loc:hi(e.loc)},r=this.tomlVersion.gte(1,1)?void 0:"invalid-inline-table-newline",o=t.nextToken({needSameLine:r});if(o){if(Cu(o)||Ll(o))return this.processInlineTableKeyValue(o,s,n,t);if(am(o))return Ki(s,o),n.set(s)}return t.reportParseError("unexpected-token",o)}processInlineTableKeyValue(e,t,n,s){let r={type:"TOMLKeyValue",key:null,value:null,parent:t,range:ci(e.range),loc:hi(e.loc)};t.body.push(r);let{nextToken:o}=this.processKeyNode(e,r,s);if(!Rv(o))return s.reportParseError("missing-equals-sign",o);let a=this.tomlVersion.gte(1,1)?void 0:"invalid-inline-table-newline";return s.addValueContainer({parent:r,set:l=>{r.value=l,Ki(r,l);let c=s.nextToken({needSameLine:a});if(Lv(c)){if(c=s.nextToken({needSameLine:a}),c&&(Cu(c)||Ll(c)))return this.processInlineTableKeyValue(c,t,n,s);if(am(c)){if(this.tomlVersion.lt(1,1))return s.reportParseError("invalid-trailing-comma-in-inline-table",c)}else return s.reportParseError(c?"unexpected-token":"unterminated-inline-table",c)}return am(c)?(Ki(t,c),n.set(t)):s.reportParseError(c?"missing-comma":"unterminated-inline-table",c)}}),s.needSameLine="invalid-key-value-newline",["VALUE"]}};Ru.TOMLParser=lm;function iC(i){return qr(i)&&i.value==="."}function Rv(i){return qr(i)&&i.value==="="}function om(i){return qr(i)&&i.value==="["}function Rl(i){return qr(i)&&i.value==="]"}function sC(i){return qr(i)&&i.value==="{"}function am(i){return qr(i)&&i.value==="}"}function Lv(i){return qr(i)&&i.value===","}function qr(i){return!!(i&&i.type==="Punctuator")}function Cu(i){return i.type==="Bare"}function Ll(i){return i.type==="BasicString"||i.type==="LiteralString"}function Iv(i){return i.type==="MultiLineBasicString"||i.type==="MultiLineLiteralString"}function rC(i){return i.type==="Integer"||i.type==="Float"}function oC(i){return i.type==="Boolean"}function aC(i){return i.type==="OffsetDateTime"||i.type==="LocalDateTime"||i.type==="LocalDate"||i.type==="LocalTime"}function Ki(i,e){e&&(i.range[1]=e.range[1],i.loc.end=Pu(e.loc.end))}function ci(i){return[i[0],i[1]]}function hi(i){return{start:Pu(i.start),end:Pu(i.end)}}function Pu(i){return{line:i.line,column:i.column}}});var Nv=kn(Dl=>{"use strict";Object.defineProperty(Dl,"__esModule",{value:!0});var Il={ArrayExpression:["elements"],ArrayPattern:["elements"],ArrowFunctionExpression:["params","body"],AssignmentExpression:["left","right"],AssignmentPattern:["left","right"],AwaitExpression:["argument"],BinaryExpression:["left","right"],BlockStatement:["body"],BreakStatement:["label"],CallExpression:["callee","arguments"],CatchClause:["param","body"],ChainExpression:["expression"],ClassBody:["body"],ClassDeclaration:["id","superClass","body"],ClassExpression:["id","superClass","body"],ConditionalExpression:["test","consequent","alternate"],ContinueStatement:["label"],DebuggerStatement:[],DoWhileStatement:["body","test"],EmptyStatement:[],ExperimentalRestProperty:["argument"],ExperimentalSpreadProperty:["argument"],ExportAllDeclaration:["exported","source"],ExportDefaultDeclaration:["declaration"],ExportNamedDeclaration:["declaration","specifiers","source"],ExportSpecifier:["exported","local"],ExpressionStatement:["expression"],ForInStatement:["left","right","body"],ForOfStatement:["left","right","body"],ForStatement:["init","test","update","body"],FunctionDeclaration:["id","params","body"],FunctionExpression:["id","params","body"],Identifier:[],IfStatement:["test","consequent","alternate"],ImportDeclaration:["specifiers","source"],ImportDefaultSpecifier:["local"],ImportExpression:["source"],ImportNamespaceSpecifier:["local"],ImportSpecifier:["imported","local"],JSXAttribute:["name","value"],JSXClosingElement:["name"],JSXClosingFragment:[],JSXElement:["openingElement","children","closingElement"],JSXEmptyExpression:[],JSXExpressionContainer:["expression"],JSXFragment:["openingFragment","children","closingFragment"],JSXIdentifier:[],JSXMemberExpression:["object","property"],JSXNamespacedName:["namespace","name"],JSXOpeningElement:["name","attributes"],JSXOpeningFragment:[],JSXSpreadAttribute:["argument"],JSXSpreadChild:["expression"],JSXText:[],LabeledStatement:["label","body"],Literal:[],LogicalExpression:["left","right"],MemberExpression:["object","property"],MetaProperty:["meta","property"],MethodDefinition:["key","value"],NewExpression:["callee","arguments"],ObjectExpression:["properties"],ObjectPattern:["properties"],PrivateIdentifier:[],Program:["body"],Property:["key","value"],PropertyDefinition:["key","value"],RestElement:["argument"],ReturnStatement:["argument"],SequenceExpression:["expressions"],SpreadElement:["argument"],StaticBlock:["body"],Super:[],SwitchCase:["test","consequent"],SwitchStatement:["discriminant","cases"],TaggedTemplateExpression:["tag","quasi"],TemplateElement:[],TemplateLiteral:["quasis","expressions"],ThisExpression:[],ThrowStatement:["argument"],TryStatement:["block","handler","finalizer"],UnaryExpression:["argument"],UpdateExpression:["argument"],VariableDeclaration:["declarations"],VariableDeclarator:["id","init"],WhileStatement:["test","body"],WithStatement:["object","body"],YieldExpression:["argument"]},lC=Object.keys(Il);for(let i of lC)Object.freeze(Il[i]);Object.freeze(Il);var cC=new Set(["parent","leadingComments","trailingComments"]);function hC(i){return!cC.has(i)&&i[0]!=="_"}function uC(i){return Object.keys(i).filter(hC)}function dC(i){let e=Object.assign({},Il);for(let t of Object.keys(i))if(Object.prototype.hasOwnProperty.call(e,t)){let n=new Set(i[t]);for(let s of e[t])n.add(s);e[t]=Object.freeze(Array.from(n))}else e[t]=Object.freeze(Array.from(i[t]));return Object.freeze(e)}Dl.KEYS=Il;Dl.getKeys=uC;Dl.unionWith=dC});var Iu=kn(Lu=>{"use strict";Object.defineProperty(Lu,"__esModule",{value:!0});Lu.KEYS=void 0;var fC=Nv(),pC={Program:["body"],TOMLTopLevelTable:["body"],TOMLTable:["key","body"],TOMLKeyValue:["key","value"],TOMLKey:["keys"],TOMLArray:["elements"],TOMLInlineTable:["body"],TOMLBare:[],TOMLQuoted:[],TOMLValue:[]};Lu.KEYS=(0,fC.unionWith)(pC)});var kv=kn(Du=>{"use strict";Object.defineProperty(Du,"__esModule",{value:!0});Du.parseForESLint=void 0;var mC=Dv(),gC=Iu();function _C(i,e){return{ast:new mC.TOMLParser(i,e).parse(),visitorKeys:gC.KEYS,services:{isTOML:!0}}}Du.parseForESLint=_C});var zv=kn(ys=>{"use strict";Object.defineProperty(ys,"__esModule",{value:!0});ys.traverseNodes=ys.getNodes=ys.getKeys=ys.getFallbackKeys=void 0;var vC=Iu();function yC(i){let e=null;return i!=="comments"&&i!=="leadingComments"&&i!=="loc"&&i!=="parent"&&i!=="range"&&i!=="tokens"&&i!=="trailingComments"&&(e=this[i])!==null&&typeof e=="object"&&(typeof e.type=="string"||Array.isArray(e))}function Uv(i){return Object.keys(i).filter(yC,i)}ys.getFallbackKeys=Uv;function Fv(i,e){return((e||vC.KEYS)[i.type]||Uv(i)).filter(n=>!cm(i,n).next().done)}ys.getKeys=Fv;function*cm(i,e){let t=i[e];if(Array.isArray(t))for(let n of t)Ov(n)&&(yield n);else Ov(t)&&(yield t)}ys.getNodes=cm;function Ov(i){return i!==null&&typeof i=="object"&&typeof i.type=="string"}function Bv(i,e,t){t.enterNode(i,e);let n=Fv(i,t.visitorKeys);for(let s of n)for(let r of cm(i,s))Bv(r,i,t);t.leaveNode(i,e)}function xC(i,e){Bv(i,null,e)}ys.traverseNodes=xC});var Hv=kn(na=>{"use strict";Object.defineProperty(na,"__esModule",{value:!0});na.generateConvertTOMLValue=na.getStaticTOMLValue=void 0;var Vv=pu();na.getStaticTOMLValue=Gv(i=>i.value);function Gv(i){function e(n,s){return t[n.type](n,s)}let t={Program(n,s={}){return e(n.body[0],s)},TOMLTopLevelTable(n,s={}){for(let r of n.body)e(r,s);return s},TOMLKeyValue(n,s={}){let r=e(n.value);return wC(s,e(n.key),r),s},TOMLTable(n,s={}){let r=bC(s,e(n.key),n.kind==="array");for(let o of n.body)e(o,r);return s},TOMLArray(n){return n.elements.map(s=>e(s))},TOMLInlineTable(n){let s={};for(let r of n.body)e(r,s);return s},TOMLKey(n){return n.keys.map(s=>e(s))},TOMLBare(n){return n.name},TOMLQuoted(n){return n.value},TOMLValue(n){return i(n)}};return n=>e(n)}na.generateConvertTOMLValue=Gv;function bC(i,e,t){let n=i;for(let l=0;l<e.length-1;l++){let c=e[l];n=a(n,c)}let s=(0,Vv.last)(e),r=n[s];if(r==null){let l={};return n[s]=t?[l]:l,l}if(Nu(r)){let l={};return n[s]=t?[l]:l,l}if(!t){if(Array.isArray(r)){let l={};return n[s]=l,l}return r}if(Array.isArray(r)){let l={};return r.push(l),l}let o={};return n[s]=[o],o;function a(l,c){let h=l[c];if(h==null){let d={};return l[c]=d,d}if(Nu(h)){let d={};return l[c]=d,d}let u=h;for(;Array.isArray(u);){let d=u.length-1,f=u[d];if(Nu(f)){let g={};return u[d]=g,g}u=f}return u}}function wC(i,e,t){let n=i;for(let s=0;s<e.length-1;s++){let r=e[s],o=n[r];if(o==null){let a={};n[r]=a,n=a}else if(Nu(o)||Array.isArray(o)){let a={};n[r]=a,n=a}else n=o}n[(0,Vv.last)(e)]=t}function Nu(i){return typeof i!="object"||i instanceof Date}});var hm=kn(ia=>{"use strict";Object.defineProperty(ia,"__esModule",{value:!0});ia.version=ia.name=void 0;ia.name="toml-eslint-parser";ia.version="0.10.0"});var Xv=kn(Jt=>{"use strict";var SC=Jt&&Jt.__createBinding||(Object.create?(function(i,e,t,n){n===void 0&&(n=t);var s=Object.getOwnPropertyDescriptor(e,t);(!s||("get"in s?!e.__esModule:s.writable||s.configurable))&&(s={enumerable:!0,get:function(){return e[t]}}),Object.defineProperty(i,n,s)}):(function(i,e,t,n){n===void 0&&(n=t),i[n]=e[t]})),MC=Jt&&Jt.__setModuleDefault||(Object.create?(function(i,e){Object.defineProperty(i,"default",{enumerable:!0,value:e})}):function(i,e){i.default=e}),TC=Jt&&Jt.__importStar||function(i){if(i&&i.__esModule)return i;var e={};if(i!=null)for(var t in i)t!=="default"&&Object.prototype.hasOwnProperty.call(i,t)&&SC(e,i,t);return MC(e,i),e};Object.defineProperty(Jt,"__esModule",{value:!0});Jt.parseTOML=Jt.getStaticTOMLValue=Jt.traverseNodes=Jt.VisitorKeys=Jt.parseForESLint=Jt.ParseError=Jt.name=Jt.meta=void 0;var Wv=kv();Object.defineProperty(Jt,"parseForESLint",{enumerable:!0,get:function(){return Wv.parseForESLint}});var EC=zv();Object.defineProperty(Jt,"traverseNodes",{enumerable:!0,get:function(){return EC.traverseNodes}});var AC=Hv();Object.defineProperty(Jt,"getStaticTOMLValue",{enumerable:!0,get:function(){return AC.getStaticTOMLValue}});var CC=Iu(),PC=yu();Object.defineProperty(Jt,"ParseError",{enumerable:!0,get:function(){return PC.ParseError}});Jt.meta=TC(hm());var RC=hm();Object.defineProperty(Jt,"name",{enumerable:!0,get:function(){return RC.name}});Jt.VisitorKeys=CC.KEYS;function LC(i,e){return(0,Wv.parseForESLint)(i,e).ast}Jt.parseTOML=LC});function A(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))n.setAttribute(s,r);return n.append(...t),n}function Ne(i,e){i.textContent!==e&&(i.textContent=e)}function St(i,e,t){i.classList.contains(e)!==t&&i.classList.toggle(e,t)}function Ke(i,e,t){i.getAttribute(e)!==t&&i.setAttribute(e,t)}function lc(i,e,t){let n=i.textContent;i.addEventListener("click",()=>{i.textContent===n?Ne(i,e):t()}),i.addEventListener("blur",()=>{Ne(i,n)})}function hs(i){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 16 16"),e.setAttribute("aria-hidden","true"),e.classList.add("icon");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",Lw[i]),e.append(t),e}var Lw={play:"M4 2.5v11l9-5.5z",pause:"M4 3h3v10H4zM9 3h3v10H9z",record:"M8 3.5a4.5 4.5 0 1 0 0 9 4.5 4.5 0 0 0 0-9z",wheel:"M8 1.5a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 0 1 4.3 3.2L9.6 7a1.8 1.8 0 0 0-3.2 0l-2.7-.3A4.5 4.5 0 0 1 8 3.5zM7 12.4A4.5 4.5 0 0 1 3.6 8.7l2.6.4.8 1zm2 0v-2.3l.8-1 2.6-.4A4.5 4.5 0 0 1 9 12.4z",square:"M4 4h8v8H4z",close:"M4 5l1-1 3 3 3-3 1 1-3 3 3 3-1 1-3-3-3 3-1-1 3-3z",stop:"M5.3 1.5h5.4l3.8 3.8v5.4l-3.8 3.8H5.3l-3.8-3.8V5.3z"};var mr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},gr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},O0=0,ep=1,U0=2;var Ur=1,F0=2,Xo=3,_r=0,ii=1,ai=2,Fr=0,qo=1,tp=2,np=3,ip=4,B0=5;var Br=100,z0=101,V0=102,G0=103,H0=104,W0=200,X0=201,q0=202,$0=203,sp=204,rp=205,Y0=206,K0=207,Z0=208,J0=209,j0=210,Q0=211,e_=212,t_=213,n_=214,Uc=0,Fc=1,Bc=2,Uo=3,zc=4,Vc=5,Gc=6,Hc=7,mh=0,i_=1,s_=2,gs=0,op=1,ap=2,lp=3,cp=4,hp=5,up=6,dp=7;var fp=300,zr=301,$o=302,gh=303,_h=304,Wc=1e3,ds=1001,Xc=1002,yn=1003,r_=1004;var pl=1005;var ti=1006,vh=1007;var Xs=1008;var li=1009,pp=1010,mp=1011,Yo=1012,yh=1013,qi=1014,Ri=1015,$i=1016,xh=1017,bh=1018,Vr=1020,gp=35902,_p=35899,vp=1021,yp=1022,Yi=1023,zs=1026,qs=1027,wh=1028,Sh=1029,vr=1030,Mh=1031;var Th=1033,ml=33776,gl=33777,_l=33778,vl=33779,Eh=35840,Ah=35841,Ch=35842,Ph=35843,Rh=36196,Lh=37492,Ih=37496,Dh=37488,Nh=37489,yl=37490,kh=37491,Oh=37808,Uh=37809,Fh=37810,Bh=37811,zh=37812,Vh=37813,Gh=37814,Hh=37815,Wh=37816,Xh=37817,qh=37818,$h=37819,Yh=37820,Kh=37821,Zh=36492,Jh=36494,jh=36495,Qh=36283,eu=36284,xl=36285,tu=36286;var Ha=2300,qc=2301,kc=2302,$f=2303,Yf=2400,Kf=2401,Zf=2402;var o_=3200;var nu=0,a_=1,$s="",Qn="srgb",Wa="srgb-linear",Xa="linear",Pt="srgb";var Oc=7680;var l_=519,c_=512,h_=513,u_=514,xp=515,d_=516,f_=517,bp=518,wp=519,p_=35044;var Sp="300 es",Ai=2e3,Fo=2001;function Iw(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Dw(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function qa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function m_(){let i=qa("canvas");return i.style.display="block",i}var o0={},Bo=null;function Mp(...i){let e="THREE."+i.shift();Bo?Bo("log",e,...i):console.log(e,...i)}function g_(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function $e(...i){i=g_(i);let e="THREE."+i.shift();if(Bo)Bo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function nt(...i){i=g_(i);let e="THREE."+i.shift();if(Bo)Bo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Va(...i){let e=i.join(" ");e in o0||(o0[e]=!0,$e(...i))}function __(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var v_={[Uc]:Uc,[Bc]:Gc,[zc]:zc,[Uo]:Vc,[Fc]:Fc,[Gc]:Bc,[Hc]:Hc,[Vc]:Uo},Hi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Xn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],a0=1234567,ko=Math.PI/180,zo=180/Math.PI;function Ko(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Xn[i&255]+Xn[i>>8&255]+Xn[i>>16&255]+Xn[i>>24&255]+"-"+Xn[e&255]+Xn[e>>8&255]+"-"+Xn[e>>16&15|64]+Xn[e>>24&255]+"-"+Xn[t&63|128]+Xn[t>>8&255]+"-"+Xn[t>>16&255]+Xn[t>>24&255]+Xn[n&255]+Xn[n>>8&255]+Xn[n>>16&255]+Xn[n>>24&255]).toLowerCase()}function _t(i,e,t){return Math.max(e,Math.min(t,i))}function Tp(i,e){return(i%e+e)%e}function Nw(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function kw(i,e,t){return i!==e?(t-i)/(e-i):0}function Ga(i,e,t){return(1-t)*i+t*e}function Ow(i,e,t,n){return Ga(i,e,1-Math.exp(-t*n))}function Uw(i,e=1){return e-Math.abs(Tp(i,e*2)-e)}function Fw(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function Bw(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function zw(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Vw(i,e){return i+Math.random()*(e-i)}function Gw(i){return i*(.5-Math.random())}function Hw(i){i!==void 0&&(a0=i);let e=a0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Ww(i){return i*ko}function Xw(i){return i*zo}function qw(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function $w(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Ep(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Yw(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*f,a*h,a*c);break;default:$e("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Ap(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function y_(i,e){if(e.constructor===Float32Array)return i;let t=Ap(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function x_(i,e){if(e.constructor===Float32Array)return i;let t=Ap(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Cp={DEG2RAD:ko,RAD2DEG:zo,generateUUID:Ko,clamp:_t,euclideanModulo:Tp,mapLinear:Nw,inverseLerp:kw,lerp:Ga,damp:Ow,pingpong:Uw,smoothstep:Fw,smootherstep:Bw,randInt:zw,randFloat:Vw,randFloatSpread:Gw,seededRandom:Hw,degToRad:Ww,radToDeg:Xw,isPowerOfTwo:qw,ceilPowerOfTwo:$w,floorPowerOfTwo:Ep,setQuaternionFromProperEuler:Yw,normalize:x_,denormalize:y_},Dp=class Dp{constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(_t(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};Dp.prototype.isVector2=!0;var et=Dp,ni=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(u!==y||l!==d||c!==f||h!==g){let p=l*d+c*f+h*g+u*y;p<0&&(d=-d,f=-f,g=-g,y=-y,p=-p);let m=1-a;if(p<.9995){let x=Math.acos(p),C=Math.sin(x);m=Math.sin(m*x)/C,a=Math.sin(a*x)/C,l=l*m+d*a,c=c*m+f*a,h=h*m+g*a,u=u*m+y*a}else{l=l*m+d*a,c=c*m+f*a,h=h*m+g*a,u=u*m+y*a;let x=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=x,c*=x,h*=x,u*=x}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*f-c*d,e[t+1]=l*g+h*d+c*u-a*f,e[t+2]=c*g+h*f+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"YZX":this._x=d*h*u+c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u-d*f*g;break;case"XZY":this._x=d*h*u-c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u+d*f*g;break;default:$e("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(_t(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Np=class Np{constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(l0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(l0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Tf.copy(this).projectOnVector(e),this.sub(Tf)}reflect(e){return this.sub(Tf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(_t(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};Np.prototype.isVector3=!0;var $=Np,Tf=new $,l0=new ni,kp=class kp{constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],g=n[8],y=s[0],p=s[3],m=s[6],x=s[1],C=s[4],M=s[7],R=s[2],T=s[5],v=s[8];return r[0]=o*y+a*x+l*R,r[3]=o*p+a*C+l*T,r[6]=o*m+a*M+l*v,r[1]=c*y+h*x+u*R,r[4]=c*p+h*C+u*T,r[7]=c*m+h*M+u*v,r[2]=d*y+f*x+g*R,r[5]=d*p+f*C+g*T,r[8]=d*m+f*M+g*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,g=t*u+n*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=u*y,e[1]=(s*c-h*n)*y,e[2]=(a*n-s*o)*y,e[3]=d*y,e[4]=(h*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=f*y,e[7]=(n*l-c*t)*y,e[8]=(o*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Va("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ef.makeScale(e,t)),this}rotate(e){return Va("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ef.makeRotation(-e)),this}translate(e,t){return Va("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ef.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}};kp.prototype.isMatrix3=!0;var it=kp,Ef=new it,c0=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),h0=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Kw(){let i={enabled:!0,workingColorSpace:Wa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=Bs(s.r),s.g=Bs(s.g),s.b=Bs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=Oo(s.r),s.g=Oo(s.g),s.b=Oo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===$s?Xa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Wa]:{primaries:e,whitePoint:n,transfer:Xa,toXYZ:c0,fromXYZ:h0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Qn},outputColorSpaceConfig:{drawingBufferColorSpace:Qn}},[Qn]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:c0,fromXYZ:h0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Qn}}}),i}var xt=Kw();function Bs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Oo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var bo,$c=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{bo===void 0&&(bo=qa("canvas")),bo.width=e.width,bo.height=e.height;let s=bo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=bo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=qa("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Bs(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Bs(t[n]/255)*255):t[n]=Bs(t[n]);return{data:t,width:e.width,height:e.height}}else return $e("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Zw=0,Vo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Zw++}),this.uuid=Ko(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Af(s[o].image)):r.push(Af(s[o]))}else r=Af(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Af(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?$c.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:($e("Texture: Unable to serialize Texture."),{})}var Jw=0,Cf=new $,oi=class i extends Hi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ds,s=ds,r=ti,o=Xs,a=Yi,l=li,c=i.DEFAULT_ANISOTROPY,h=$s){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Jw++}),this.uuid=Ko(),this.name="",this.source=new Vo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new et(0,0),this.repeat=new et(1,1),this.center=new et(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Cf).x}get height(){return this.source.getSize(Cf).y}get depth(){return this.source.getSize(Cf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){$e(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==fp)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Wc:e.x=e.x-Math.floor(e.x);break;case ds:e.x=e.x<0?0:1;break;case Xc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Wc:e.y=e.y-Math.floor(e.y);break;case ds:e.y=e.y<0?0:1;break;case Xc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};oi.DEFAULT_IMAGE=null;oi.DEFAULT_MAPPING=fp;oi.DEFAULT_ANISOTROPY=1;var Op=class Op{constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],g=l[9],y=l[2],p=l[6],m=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+y)<.1&&Math.abs(g+p)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,M=(f+1)/2,R=(m+1)/2,T=(h+d)/4,v=(u+y)/4,E=(g+p)/4;return C>M&&C>R?C<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(C),s=T/n,r=v/n):M>R?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=T/s,r=E/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=v/r,s=E/r),this.set(n,s,r,t),this}let x=Math.sqrt((p-g)*(p-g)+(u-y)*(u-y)+(d-h)*(d-h));return Math.abs(x)<.001&&(x=1),this.x=(p-g)/x,this.y=(u-y)/x,this.z=(d-h)/x,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this.w=_t(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this.w=_t(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};Op.prototype.isVector4=!0;var Zt=Op,Yc=class extends Hi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ti,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Zt(0,0,e,t),this.scissorTest=!1,this.viewport=new Zt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new oi({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ti,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Vo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},yi=class extends Yc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},$a=class extends oi{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=yn,this.minFilter=yn,this.wrapR=ds,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Kc=class extends oi{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=yn,this.minFilter=yn,this.wrapR=ds,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var ph=class ph{constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,y,p)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,y,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=g,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new ph().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/wo.setFromMatrixColumn(e,0).length(),r=1/wo.setFromMatrixColumn(e,1).length(),o=1/wo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+g*c,t[5]=d-y*c,t[9]=-a*l,t[2]=y-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,g=c*h,y=c*u;t[0]=d+y*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-g,t[6]=y+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,g=c*h,y=c*u;t[0]=d-y*a,t[4]=-o*u,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*h,t[9]=y-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=g*c-f,t[8]=d*c+y,t[1]=l*u,t[5]=y*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=y-d*u,t[8]=g*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+g,t[10]=d-y*u}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+y,t[5]=o*h,t[9]=f*u-g,t[2]=g*u-f,t[6]=a*h,t[10]=y*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(jw,e,Qw)}lookAt(e,t,n){let s=this.elements;return gi.subVectors(e,t),gi.lengthSq()===0&&(gi.z=1),gi.normalize(),sr.crossVectors(n,gi),sr.lengthSq()===0&&(Math.abs(n.z)===1?gi.x+=1e-4:gi.z+=1e-4,gi.normalize(),sr.crossVectors(n,gi)),sr.normalize(),cc.crossVectors(gi,sr),s[0]=sr.x,s[4]=cc.x,s[8]=gi.x,s[1]=sr.y,s[5]=cc.y,s[9]=gi.y,s[2]=sr.z,s[6]=cc.z,s[10]=gi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],g=n[2],y=n[6],p=n[10],m=n[14],x=n[3],C=n[7],M=n[11],R=n[15],T=s[0],v=s[4],E=s[8],z=s[12],k=s[1],N=s[5],W=s[9],H=s[13],I=s[2],F=s[6],q=s[10],V=s[14],le=s[3],Z=s[7],Q=s[11],ie=s[15];return r[0]=o*T+a*k+l*I+c*le,r[4]=o*v+a*N+l*F+c*Z,r[8]=o*E+a*W+l*q+c*Q,r[12]=o*z+a*H+l*V+c*ie,r[1]=h*T+u*k+d*I+f*le,r[5]=h*v+u*N+d*F+f*Z,r[9]=h*E+u*W+d*q+f*Q,r[13]=h*z+u*H+d*V+f*ie,r[2]=g*T+y*k+p*I+m*le,r[6]=g*v+y*N+p*F+m*Z,r[10]=g*E+y*W+p*q+m*Q,r[14]=g*z+y*H+p*V+m*ie,r[3]=x*T+C*k+M*I+R*le,r[7]=x*v+C*N+M*F+R*Z,r[11]=x*E+C*W+M*q+R*Q,r[15]=x*z+C*H+M*V+R*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],g=e[3],y=e[7],p=e[11],m=e[15],x=l*f-c*d,C=a*f-c*u,M=a*d-l*u,R=o*f-c*h,T=o*d-l*h,v=o*u-a*h;return t*(y*x-p*C+m*M)-n*(g*x-p*R+m*T)+s*(g*C-y*R+m*v)-r*(g*M-y*T+p*v)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],g=e[12],y=e[13],p=e[14],m=e[15],x=t*a-n*o,C=t*l-s*o,M=t*c-r*o,R=n*l-s*a,T=n*c-r*a,v=s*c-r*l,E=h*y-u*g,z=h*p-d*g,k=h*m-f*g,N=u*p-d*y,W=u*m-f*y,H=d*m-f*p,I=x*H-C*W+M*N+R*k-T*z+v*E;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let F=1/I;return e[0]=(a*H-l*W+c*N)*F,e[1]=(s*W-n*H-r*N)*F,e[2]=(y*v-p*T+m*R)*F,e[3]=(d*T-u*v-f*R)*F,e[4]=(l*k-o*H-c*z)*F,e[5]=(t*H-s*k+r*z)*F,e[6]=(p*M-g*v-m*C)*F,e[7]=(h*v-d*M+f*C)*F,e[8]=(o*W-a*k+c*E)*F,e[9]=(n*k-t*W-r*E)*F,e[10]=(g*T-y*M+m*x)*F,e[11]=(u*M-h*T-f*x)*F,e[12]=(a*z-o*N-l*E)*F,e[13]=(t*N-n*z+s*E)*F,e[14]=(y*C-g*R-p*x)*F,e[15]=(h*R-u*C+d*x)*F,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,g=r*u,y=o*h,p=o*u,m=a*u,x=l*c,C=l*h,M=l*u,R=n.x,T=n.y,v=n.z;return s[0]=(1-(y+m))*R,s[1]=(f+M)*R,s[2]=(g-C)*R,s[3]=0,s[4]=(f-M)*T,s[5]=(1-(d+m))*T,s[6]=(p+x)*T,s[7]=0,s[8]=(g+C)*v,s[9]=(p-x)*v,s[10]=(1-(d+y))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=wo.set(s[0],s[1],s[2]).length(),a=wo.set(s[4],s[5],s[6]).length(),l=wo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),zi.copy(this);let c=1/o,h=1/a,u=1/l;return zi.elements[0]*=c,zi.elements[1]*=c,zi.elements[2]*=c,zi.elements[4]*=h,zi.elements[5]*=h,zi.elements[6]*=h,zi.elements[8]*=u,zi.elements[9]*=u,zi.elements[10]*=u,t.setFromRotationMatrix(zi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Ai,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===Ai)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Fo)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ai,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===Ai)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===Fo)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}};ph.prototype.isMatrix4=!0;var Rt=ph,wo=new $,zi=new Rt,jw=new $(0,0,0),Qw=new $(1,1,1),sr=new $,cc=new $,gi=new $,u0=new Rt,d0=new ni,Vs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(_t(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-_t(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(_t(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-_t(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(_t(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-_t(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:$e("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return u0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(u0,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return d0.setFromEuler(this),this.setFromQuaternion(d0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Vs.DEFAULT_ORDER="XYZ";var Ya=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},eS=0,f0=new $,So=new ni,Ds=new Rt,hc=new $,Na=new $,tS=new $,nS=new ni,p0=new $(1,0,0),m0=new $(0,1,0),g0=new $(0,0,1),_0={type:"added"},iS={type:"removed"},Mo={type:"childadded",child:null},Pf={type:"childremoved",child:null},Vn=class i extends Hi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:eS++}),this.uuid=Ko(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new $,t=new Vs,n=new ni,s=new $(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Rt},normalMatrix:{value:new it}}),this.matrix=new Rt,this.matrixWorld=new Rt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ya,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return So.setFromAxisAngle(e,t),this.quaternion.multiply(So),this}rotateOnWorldAxis(e,t){return So.setFromAxisAngle(e,t),this.quaternion.premultiply(So),this}rotateX(e){return this.rotateOnAxis(p0,e)}rotateY(e){return this.rotateOnAxis(m0,e)}rotateZ(e){return this.rotateOnAxis(g0,e)}translateOnAxis(e,t){return f0.copy(e).applyQuaternion(this.quaternion),this.position.add(f0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(p0,e)}translateY(e){return this.translateOnAxis(m0,e)}translateZ(e){return this.translateOnAxis(g0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ds.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?hc.copy(e):hc.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Na.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ds.lookAt(Na,hc,this.up):Ds.lookAt(hc,Na,this.up),this.quaternion.setFromRotationMatrix(Ds),s&&(Ds.extractRotation(s.matrixWorld),So.setFromRotationMatrix(Ds),this.quaternion.premultiply(So.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(_0),Mo.child=e,this.dispatchEvent(Mo),Mo.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(iS),Pf.child=e,this.dispatchEvent(Pf),Pf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ds.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ds.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ds),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(_0),Mo.child=e,this.dispatchEvent(Mo),Mo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Na,e,tS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Na,nS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Vn.DEFAULT_UP=new $(0,1,0);Vn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Vn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ci=class extends Vn{constructor(){super(),this.isGroup=!0,this.type="Group"}},sS={type:"move"},Go=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ci,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ci,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new $,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new $),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ci,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new $,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new $,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let p=t.getJointPose(y,n),m=this._getHandJoint(c,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(sS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Ci;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},b_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},rr={h:0,s:0,l:0},uc={h:0,s:0,l:0};function Rf(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ut=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Qn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=n,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=xt.workingColorSpace){if(e=Tp(e,1),t=_t(t,0,1),n=_t(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Rf(o,r,e+1/3),this.g=Rf(o,r,e),this.b=Rf(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=Qn){function n(r){r!==void 0&&parseFloat(r)<1&&$e("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:$e("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);$e("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Qn){let n=b_[e.toLowerCase()];return n!==void 0?this.setHex(n,t):$e("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Bs(e.r),this.g=Bs(e.g),this.b=Bs(e.b),this}copyLinearToSRGB(e){return this.r=Oo(e.r),this.g=Oo(e.g),this.b=Oo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Qn){return xt.workingToColorSpace(qn.copy(this),e),Math.round(_t(qn.r*255,0,255))*65536+Math.round(_t(qn.g*255,0,255))*256+Math.round(_t(qn.b*255,0,255))}getHexString(e=Qn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace(qn.copy(this),t);let n=qn.r,s=qn.g,r=qn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace(qn.copy(this),t),e.r=qn.r,e.g=qn.g,e.b=qn.b,e}getStyle(e=Qn){xt.workingToColorSpace(qn.copy(this),e);let t=qn.r,n=qn.g,s=qn.b;return e!==Qn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(rr),this.setHSL(rr.h+e,rr.s+t,rr.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(rr),e.getHSL(uc);let n=Ga(rr.h,uc.h,t),s=Ga(rr.s,uc.s,t),r=Ga(rr.l,uc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},qn=new ut;ut.NAMES=b_;var Ka=class i{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new ut(e),this.near=t,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},Za=class extends Vn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Vs,this.environmentIntensity=1,this.environmentRotation=new Vs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Vi=new $,Ns=new $,Lf=new $,ks=new $,To=new $,Eo=new $,v0=new $,If=new $,Df=new $,Nf=new $,kf=new Zt,Of=new Zt,Uf=new Zt,Fs=class i{constructor(e=new $,t=new $,n=new $){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Vi.subVectors(e,t),s.cross(Vi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Vi.subVectors(s,t),Ns.subVectors(n,t),Lf.subVectors(e,t);let o=Vi.dot(Vi),a=Vi.dot(Ns),l=Vi.dot(Lf),c=Ns.dot(Ns),h=Ns.dot(Lf),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,g=(o*h-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,ks)===null?!1:ks.x>=0&&ks.y>=0&&ks.x+ks.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,ks)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ks.x),l.addScaledVector(o,ks.y),l.addScaledVector(a,ks.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return kf.setScalar(0),Of.setScalar(0),Uf.setScalar(0),kf.fromBufferAttribute(e,t),Of.fromBufferAttribute(e,n),Uf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(kf,r.x),o.addScaledVector(Of,r.y),o.addScaledVector(Uf,r.z),o}static isFrontFacing(e,t,n,s){return Vi.subVectors(n,t),Ns.subVectors(e,t),Vi.cross(Ns).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Vi.subVectors(this.c,this.b),Ns.subVectors(this.a,this.b),Vi.cross(Ns).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;To.subVectors(s,n),Eo.subVectors(r,n),If.subVectors(e,n);let l=To.dot(If),c=Eo.dot(If);if(l<=0&&c<=0)return t.copy(n);Df.subVectors(e,s);let h=To.dot(Df),u=Eo.dot(Df);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(To,o);Nf.subVectors(e,r);let f=To.dot(Nf),g=Eo.dot(Nf);if(g>=0&&f<=g)return t.copy(r);let y=f*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(Eo,a);let p=h*g-f*u;if(p<=0&&u-h>=0&&f-g>=0)return v0.subVectors(r,s),a=(u-h)/(u-h+(f-g)),t.copy(s).addScaledVector(v0,a);let m=1/(p+y+d);return o=y*m,a=d*m,t.copy(n).addScaledVector(To,o).addScaledVector(Eo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},fs=class{constructor(e=new $(1/0,1/0,1/0),t=new $(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Gi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Gi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Gi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Gi):Gi.fromBufferAttribute(r,o),Gi.applyMatrix4(e.matrixWorld),this.expandByPoint(Gi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),dc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),dc.copy(n.boundingBox)),dc.applyMatrix4(e.matrixWorld),this.union(dc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Gi),Gi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ka),fc.subVectors(this.max,ka),Ao.subVectors(e.a,ka),Co.subVectors(e.b,ka),Po.subVectors(e.c,ka),or.subVectors(Co,Ao),ar.subVectors(Po,Co),Rr.subVectors(Ao,Po);let t=[0,-or.z,or.y,0,-ar.z,ar.y,0,-Rr.z,Rr.y,or.z,0,-or.x,ar.z,0,-ar.x,Rr.z,0,-Rr.x,-or.y,or.x,0,-ar.y,ar.x,0,-Rr.y,Rr.x,0];return!Ff(t,Ao,Co,Po,fc)||(t=[1,0,0,0,1,0,0,0,1],!Ff(t,Ao,Co,Po,fc))?!1:(pc.crossVectors(or,ar),t=[pc.x,pc.y,pc.z],Ff(t,Ao,Co,Po,fc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Gi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Gi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Os[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Os[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Os[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Os[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Os[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Os[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Os[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Os[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Os),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Os=[new $,new $,new $,new $,new $,new $,new $,new $],Gi=new $,dc=new fs,Ao=new $,Co=new $,Po=new $,or=new $,ar=new $,Rr=new $,ka=new $,fc=new $,pc=new $,Lr=new $;function Ff(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Lr.fromArray(i,r);let a=s.x*Math.abs(Lr.x)+s.y*Math.abs(Lr.y)+s.z*Math.abs(Lr.z),l=e.dot(Lr),c=t.dot(Lr),h=n.dot(Lr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var vn=new $,mc=new et,rS=0,Un=class extends Hi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:rS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=p_,this.updateRanges=[],this.gpuType=Ri,this.version=0,this._normalizationScale=e!==void 0?Ap(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)mc.fromBufferAttribute(this,t),mc.applyMatrix3(e),this.setXY(t,mc.x,mc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)vn.fromBufferAttribute(this,t),vn.applyMatrix3(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)vn.fromBufferAttribute(this,t),vn.applyMatrix4(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)vn.fromBufferAttribute(this,t),vn.applyNormalMatrix(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)vn.fromBufferAttribute(this,t),vn.transformDirection(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):y_(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):x_(e,this.array)}};var Ja=class extends Un{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var ja=class extends Un{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Fn=class extends Un{constructor(e,t,n){super(new Float32Array(e),t,n)}},oS=new fs,Oa=new $,Bf=new $,Gs=class{constructor(e=new $,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):oS.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Oa.subVectors(e,this.center);let t=Oa.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Oa,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Bf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Oa.copy(e.center).add(Bf)),this.expandByPoint(Oa.copy(e.center).sub(Bf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},aS=0,Ei=new Rt,zf=new Vn,Ro=new $,_i=new fs,Ua=new fs,On=new $,Gn=class i extends Hi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:aS++}),this.uuid=Ko(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Iw(e)?ja:Ja)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new it().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ei.makeRotationFromQuaternion(e),this.applyMatrix4(Ei),this}rotateX(e){return Ei.makeRotationX(e),this.applyMatrix4(Ei),this}rotateY(e){return Ei.makeRotationY(e),this.applyMatrix4(Ei),this}rotateZ(e){return Ei.makeRotationZ(e),this.applyMatrix4(Ei),this}translate(e,t,n){return Ei.makeTranslation(e,t,n),this.applyMatrix4(Ei),this}scale(e,t,n){return Ei.makeScale(e,t,n),this.applyMatrix4(Ei),this}lookAt(e){return zf.lookAt(e),zf.updateMatrix(),this.applyMatrix4(zf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ro).negate(),this.translate(Ro.x,Ro.y,Ro.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Fn(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&$e("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new fs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new $(-1/0,-1/0,-1/0),new $(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];_i.setFromBufferAttribute(r),this.morphTargetsRelative?(On.addVectors(this.boundingBox.min,_i.min),this.boundingBox.expandByPoint(On),On.addVectors(this.boundingBox.max,_i.max),this.boundingBox.expandByPoint(On)):(this.boundingBox.expandByPoint(_i.min),this.boundingBox.expandByPoint(_i.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Gs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new $,1/0);return}if(e){let n=this.boundingSphere.center;if(_i.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ua.setFromBufferAttribute(a),this.morphTargetsRelative?(On.addVectors(_i.min,Ua.min),_i.expandByPoint(On),On.addVectors(_i.max,Ua.max),_i.expandByPoint(On)):(_i.expandByPoint(Ua.min),_i.expandByPoint(Ua.max))}_i.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)On.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(On));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)On.fromBufferAttribute(a,c),l&&(Ro.fromBufferAttribute(e,c),On.add(Ro)),s=Math.max(s,n.distanceToSquared(On))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Un(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let z=0;z<n.count;z++)a[z]=new $,l[z]=new $;let h=new $,u=new $,d=new $,f=new et,g=new et,y=new et,p=new $,m=new $;function x(z,k,N){c[z]=c[k]=c[N]=1,h.fromBufferAttribute(n,z),u.fromBufferAttribute(n,k),d.fromBufferAttribute(n,N),f.fromBufferAttribute(r,z),g.fromBufferAttribute(r,k),y.fromBufferAttribute(r,N),u.sub(h),d.sub(h),g.sub(f),y.sub(f);let W=1/(g.x*y.y-y.x*g.y);isFinite(W)&&(p.copy(u).multiplyScalar(y.y).addScaledVector(d,-g.y).multiplyScalar(W),m.copy(d).multiplyScalar(g.x).addScaledVector(u,-y.x).multiplyScalar(W),a[z].add(p),a[k].add(p),a[N].add(p),l[z].add(m),l[k].add(m),l[N].add(m))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let z=0,k=C.length;z<k;++z){let N=C[z],W=N.start,H=N.count;for(let I=W,F=W+H;I<F;I+=3)x(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let M=new $,R=new $,T=new $,v=new $;function E(z){T.fromBufferAttribute(s,z),v.copy(T);let k=a[z];M.copy(k),M.sub(T.multiplyScalar(T.dot(k))).normalize(),R.crossVectors(v,k);let W=R.dot(l[z])<0?-1:1;o.setXYZW(z,M.x,M.y,M.z,W)}for(let z=0,k=n.count;z<k;++z)c[z]&&E(z);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Un(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new $,r=new $,o=new $,a=new $,l=new $,c=new $,h=new $,u=new $;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),y=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)On.fromBufferAttribute(e,t),On.normalize(),e.setXYZ(t,On.x,On.y,On.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,g=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*h;for(let m=0;m<h;m++)d[g++]=c[f++]}return new Un(d,h,u)}if(this.index===null)return $e("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Vf=new $,lS=new $,cS=new it,vi=class{constructor(e=new $(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Vf.subVectors(n,t).cross(lS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Vf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||cS.getNormalMatrix(e),s=this.coplanarPoint(Vf).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},hS=0,Hs=class extends Hi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:hS++}),this.uuid=Ko(),this.name="",this.type="Material",this.blending=qo,this.side=_r,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=sp,this.blendDst=rp,this.blendEquation=Br,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ut(0,0,0),this.blendAlpha=0,this.depthFunc=Uo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=l_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Oc,this.stencilZFail=Oc,this.stencilZPass=Oc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){$e(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ut().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new vi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new et().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new et().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Us=new $,Gf=new $,gc=new $,_c=new $,Nr=class{constructor(e=new $,t=new $(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Us)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Us.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Us.copy(this.origin).addScaledVector(this.direction,t),Us.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Gf.copy(e).add(t).multiplyScalar(.5),gc.copy(t).sub(e).normalize(),_c.copy(this.origin).sub(Gf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(gc),a=_c.dot(this.direction),l=-_c.dot(gc),c=_c.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*l-a,d=o*a-l,g=r*h,u>=0)if(d>=-g)if(d<=g){let y=1/h;u*=y,d*=y,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Gf).addScaledVector(gc,d),f}intersectSphere(e,t){if(e.radius<0)return null;Us.subVectors(e.center,this.origin);let n=Us.dot(this.direction),s=Us.dot(Us)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Us)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,y=t.y-o.y,p=t.z-o.z,m=n.x-o.x,x=n.y-o.y,C=n.z-o.z,M=Math.abs(l),R=Math.abs(c),T=Math.abs(h),v,E,z,k,N,W,H,I,F,q,V,le;if(M>=R&&M>=T?(z=l,W=u,F=g,le=m,l>=0?(v=c,E=h,k=d,N=f,H=y,I=p,q=x,V=C):(v=h,E=c,k=f,N=d,H=p,I=y,q=C,V=x)):R>=T?(z=c,W=d,F=y,le=x,c>=0?(v=h,E=l,k=f,N=u,H=p,I=g,q=C,V=m):(v=l,E=h,k=u,N=f,H=g,I=p,q=m,V=C)):(z=h,W=f,F=p,le=C,h>=0?(v=l,E=c,k=u,N=d,H=g,I=y,q=m,V=x):(v=c,E=l,k=d,N=u,H=y,I=g,q=x,V=m)),z===0)return null;let Z=v/z,Q=E/z,ie=1/z,de=k-Z*W,ue=N-Q*W,ee=H-Z*F,me=I-Q*F,ge=q-Z*le,ve=V-Q*le,_e=ge*me-ve*ee,Ge=de*ve-ue*ge,Ze=ee*ue-me*de;if(s){if(_e<0||Ge<0||Ze<0)return null}else if((_e<0||Ge<0||Ze<0)&&(_e>0||Ge>0||Ze>0))return null;let Ue=_e+Ge+Ze;if(Ue===0)return null;let st=ie*(_e*W+Ge*F+Ze*le);return(Ue>0?st<0:st>0)?null:this.at(st/Ue,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},cr=class extends Hs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Vs,this.combine=mh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},y0=new Rt,Ir=new Nr,vc=new Gs,x0=new $,yc=new $,xc=new $,bc=new $,Hf=new $,wc=new $,b0=new $,Sc=new $,en=class extends Vn{constructor(e=new Gn,t=new cr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){wc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Hf.fromBufferAttribute(u,e),o?wc.addScaledVector(Hf,h):wc.addScaledVector(Hf.sub(t),h))}t.add(wc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),vc.copy(n.boundingSphere),vc.applyMatrix4(r),Ir.copy(e.ray).recast(e.near),!(vc.containsPoint(Ir.origin)===!1&&(Ir.intersectSphere(vc,x0)===null||Ir.origin.distanceToSquared(x0)>(e.far-e.near)**2))&&(y0.copy(r).invert(),Ir.copy(e.ray).applyMatrix4(y0),!(n.boundingBox!==null&&Ir.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Ir)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],x=Math.max(p.start,f.start),C=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let M=x,R=C;M<R;M+=3){let T=a.getX(M),v=a.getX(M+1),E=a.getX(M+2);s=Mc(this,m,e,n,c,h,u,T,v,E),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let x=a.getX(p),C=a.getX(p+1),M=a.getX(p+2);s=Mc(this,o,e,n,c,h,u,x,C,M),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],x=Math.max(p.start,f.start),C=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let M=x,R=C;M<R;M+=3){let T=M,v=M+1,E=M+2;s=Mc(this,m,e,n,c,h,u,T,v,E),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let x=p,C=p+1,M=p+2;s=Mc(this,o,e,n,c,h,u,x,C,M),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function uS(i,e,t,n,s,r,o,a){let l;if(e.side===ii?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===_r,a),l===null)return null;Sc.copy(a),Sc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Sc);return c<t.near||c>t.far?null:{distance:c,point:Sc.clone(),object:i}}function Mc(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,yc),i.getVertexPosition(l,xc),i.getVertexPosition(c,bc);let h=uS(i,e,t,n,yc,xc,bc,b0);if(h){let u=new $;Fs.getBarycoord(b0,yc,xc,bc,u),s&&(h.uv=Fs.getInterpolatedAttribute(s,a,l,c,u,new et)),r&&(h.uv1=Fs.getInterpolatedAttribute(r,a,l,c,u,new et)),o&&(h.normal=Fs.getInterpolatedAttribute(o,a,l,c,u,new $),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new $,materialIndex:0};Fs.getNormal(yc,xc,bc,d.normal),h.face=d,h.barycoord=u}return h}var kr=class extends oi{constructor(e=null,t=1,n=1,s,r,o,a,l,c=yn,h=yn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Qa=class extends Un{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Lo=new Rt,w0=new Rt,Tc=[],S0=new fs,dS=new Rt,Fa=new en,Ba=new Gs,el=class extends en{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Qa(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,dS)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new fs),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Lo),S0.copy(e.boundingBox).applyMatrix4(Lo),this.boundingBox.union(S0)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Gs),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Lo),Ba.copy(e.boundingSphere).applyMatrix4(Lo),this.boundingSphere.union(Ba)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(Fa.geometry=this.geometry,Fa.material=this.material,Fa.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ba.copy(this.boundingSphere),Ba.applyMatrix4(n),e.ray.intersectsSphere(Ba)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Lo),w0.multiplyMatrices(n,Lo),Fa.matrixWorld=w0,Fa.raycast(e,Tc);for(let o=0,a=Tc.length;o<a;o++){let l=Tc[o];l.instanceId=r,l.object=this,t.push(l)}Tc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Qa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new kr(new Float32Array(s*this.count),s,this.count,wh,Ri));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Dr=new Gs,fS=new et(.5,.5),Ec=new $,hr=class{constructor(e=new vi,t=new vi,n=new vi,s=new vi,r=new vi,o=new vi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ai,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],y=r[9],p=r[10],m=r[11],x=r[12],C=r[13],M=r[14],R=r[15];if(s[0].setComponents(c-o,f-h,m-g,R-x).normalize(),s[1].setComponents(c+o,f+h,m+g,R+x).normalize(),s[2].setComponents(c+a,f+u,m+y,R+C).normalize(),s[3].setComponents(c-a,f-u,m-y,R-C).normalize(),n)s[4].setComponents(l,d,p,M).normalize(),s[5].setComponents(c-l,f-d,m-p,R-M).normalize();else if(s[4].setComponents(c-l,f-d,m-p,R-M).normalize(),t===Ai)s[5].setComponents(c+l,f+d,m+p,R+M).normalize();else if(t===Fo)s[5].setComponents(l,d,p,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Dr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Dr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Dr)}intersectsSprite(e){Dr.center.set(0,0,0);let t=fS.distanceTo(e.center);return Dr.radius=.7071067811865476+t,Dr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Dr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Ec.x=s.normal.x>0?e.max.x:e.min.x,Ec.y=s.normal.y>0?e.max.y:e.min.y,Ec.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ec)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},M0=new Rt,Zc=class i{constructor(){this.coordinateSystem=Ai,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];M0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new hr),n[s].setFromProjectionMatrix(M0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new hr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Pi=class extends Hs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ut(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Jc=new $,jc=new $,T0=new Rt,za=new Nr,Ac=new Gs,Wf=new $,E0=new $,tl=class extends Vn{constructor(e=new Gn,t=new Pi){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Jc.fromBufferAttribute(t,s-1),jc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Jc.distanceTo(jc);e.setAttribute("lineDistance",new Fn(n,1))}else $e("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ac.copy(n.boundingSphere),Ac.applyMatrix4(s),Ac.radius+=r,e.ray.intersectsSphere(Ac)===!1)return;T0.copy(s).invert(),za.copy(e.ray).applyMatrix4(T0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=c){let m=h.getX(y),x=h.getX(y+1),C=Cc(this,e,za,l,m,x,y);C&&t.push(C)}if(this.isLineLoop){let y=h.getX(g-1),p=h.getX(f),m=Cc(this,e,za,l,y,p,g-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=c){let m=Cc(this,e,za,l,y,y+1,y);m&&t.push(m)}if(this.isLineLoop){let y=Cc(this,e,za,l,g-1,f,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Cc(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Jc.fromBufferAttribute(a,s),jc.fromBufferAttribute(a,r),t.distanceSqToSegment(Jc,jc,Wf,E0)>n)return;Wf.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Wf);if(!(c<e.near||c>e.far))return{distance:c,point:E0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var A0=new $,C0=new $,Wi=class extends tl{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)A0.fromBufferAttribute(t,s),C0.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+A0.distanceTo(C0);e.setAttribute("lineDistance",new Fn(n,1))}else $e("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},nl=class extends tl{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var il=class extends oi{constructor(e=[],t=zr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ws=class extends oi{constructor(e,t,n=qi,s,r,o,a=yn,l=yn,c,h=zs,u=1){if(h!==zs&&h!==qs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Vo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},sl=class extends Ws{constructor(e,t=qi,n=zr,s,r,o=yn,a=yn,l,c=zs){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},rl=class extends oi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ur=class i extends Gn{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Fn(c,3)),this.setAttribute("normal",new Fn(h,3)),this.setAttribute("uv",new Fn(u,2));function g(y,p,m,x,C,M,R,T,v,E,z){let k=M/v,N=R/E,W=M/2,H=R/2,I=T/2,F=v+1,q=E+1,V=0,le=0,Z=new $;for(let Q=0;Q<q;Q++){let ie=Q*N-H;for(let de=0;de<F;de++){let ue=de*k-W;Z[y]=ue*x,Z[p]=ie*C,Z[m]=I,c.push(Z.x,Z.y,Z.z),Z[y]=0,Z[p]=0,Z[m]=T>0?1:-1,h.push(Z.x,Z.y,Z.z),u.push(de/v),u.push(1-Q/E),V+=1}}for(let Q=0;Q<E;Q++)for(let ie=0;ie<v;ie++){let de=d+ie+F*Q,ue=d+ie+F*(Q+1),ee=d+(ie+1)+F*(Q+1),me=d+(ie+1)+F*Q;l.push(de,ue,me),l.push(ue,ee,me),le+=6}a.addGroup(f,le,z),f+=le,d+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Pc=new $,Rc=new $,Xf=new $,Lc=new Fs,Or=class extends Gn{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(ko*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:y,b:p,c:m}=Lc;if(y.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),m.fromBufferAttribute(a,c[2]),Lc.getNormal(Xf),u[0]=`${Math.round(y.x*s)},${Math.round(y.y*s)},${Math.round(y.z*s)}`,u[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,u[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let x=0;x<3;x++){let C=(x+1)%3,M=u[x],R=u[C],T=Lc[h[x]],v=Lc[h[C]],E=`${M}_${R}`,z=`${R}_${M}`,k=d.get(z);k?(Xf.dot(k.normal)<=r&&(f.push(T.x,T.y,T.z),f.push(v.x,v.y,v.z)),d.set(z,null)):d.has(E)||d.set(E,{index0:c[x],index1:c[C],normal:Xf.clone()})}}for(let g of d.values())if(g){let{index0:y,index1:p}=g;Pc.fromBufferAttribute(a,y),Rc.fromBufferAttribute(a,p),f.push(Pc.x,Pc.y,Pc.z),f.push(Rc.x,Rc.y,Rc.z)}this.setAttribute("position",new Fn(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var ps=class i extends Gn{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],g=[],y=[],p=[];for(let m=0;m<h;m++){let x=m*d-o;for(let C=0;C<c;C++){let M=C*u-r;g.push(M,-x,0),y.push(0,0,1),p.push(C/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let x=0;x<a;x++){let C=x+c*m,M=x+c*(m+1),R=x+1+c*(m+1),T=x+1+c*m;f.push(C,M,T),f.push(M,R,T)}this.setIndex(f),this.setAttribute("position",new Fn(g,3)),this.setAttribute("normal",new Fn(y,3)),this.setAttribute("uv",new Fn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}},ol=class i extends Gn{constructor(e=.5,t=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=e,d=(t-e)/s,f=new $,g=new et;for(let y=0;y<=s;y++){for(let p=0;p<=n;p++){let m=r+p/n*o;f.x=u*Math.cos(m),f.y=u*Math.sin(m),l.push(f.x,f.y,f.z),c.push(0,0,1),g.x=(f.x/t+1)/2,g.y=(f.y/t+1)/2,h.push(g.x,g.y)}u+=d}for(let y=0;y<s;y++){let p=y*(n+1);for(let m=0;m<n;m++){let x=m+p,C=x,M=x+n+1,R=x+n+2,T=x+1;a.push(C,M,T),a.push(M,R,T)}}this.setIndex(a),this.setAttribute("position",new Fn(l,3)),this.setAttribute("normal",new Fn(c,3)),this.setAttribute("uv",new Fn(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}};function Gr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(P0(s))s.isRenderTargetTexture?($e("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(P0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function $n(i){let e={};for(let t=0;t<i.length;t++){let n=Gr(i[t]);for(let s in n)e[s]=n[s]}return e}function P0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function pS(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Pp(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}var w_={clone:Gr,merge:$n},mS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,gS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ms=class extends Hs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=mS,this.fragmentShader=gS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Gr(e.uniforms),this.uniformsGroups=pS(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new ut().setHex(s.value);break;case"v2":this.uniforms[n].value=new et().fromArray(s.value);break;case"v3":this.uniforms[n].value=new $().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Zt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new it().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Rt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Qc=class extends ms{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Xi=class extends Hs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ut(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=nu,this.normalScale=new et(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Vs,this.combine=mh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},eh=class extends Hs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=o_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},th=class extends Hs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Io(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Ic(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var dr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},nh=class extends dr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Yf,endingEnd:Yf}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Kf:r=e,a=2*t-n;break;case Zf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Kf:o=e,l=2*n-t;break;case Zf:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),y=g*g,p=y*g,m=-d*p+2*d*y-d*g,x=(1+d)*p+(-1.5-2*d)*y+(-.5+d)*g+1,C=(-1-f)*p+(1.5+f)*y+.5*g,M=f*p-f*y;for(let R=0;R!==a;++R)r[R]=m*o[h+R]+x*o[c+R]+C*o[l+R]+M*o[u+R];return r}},ih=class extends dr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},sh=class extends dr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},rh=class extends dr{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-t)/(s-t),y=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let y=o[c+g],p=o[l+g],m=f*d+g*2,x=u[m],C=u[m+1],M=e*d+g*2,R=h[M],T=h[M+1],v=vS(n,t,x,R,s);r[g]=S_(v,y,C,T,p)}return r}};function S_(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function _S(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function vS(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=S_(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=_S(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var xi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Io(t,this.TimeBufferType),this.values=Io(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Io(e.times,Array),values:Io(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Ic(e.settings)&&(n.settings={inTangents:Io(e.settings.inTangents,Array),outTangents:Io(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new sh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new ih(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new nh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new rh(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ha:t=this.InterpolantFactoryMethodDiscrete;break;case qc:t=this.InterpolantFactoryMethodLinear;break;case kc:t=this.InterpolantFactoryMethodSmooth;break;case $f:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return $e("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ha;case this.InterpolantFactoryMethodLinear:return qc;case this.InterpolantFactoryMethodSmooth:return kc;case this.InterpolantFactoryMethodBezier:return $f}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Ic(this.settings)&&(R0(this.settings.inTangents,e),R0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Ic(this.settings)&&(L0(this.settings.inTangents,e),L0(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){nt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){nt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Dw(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){nt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===kc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let g=0;g!==n;++g){let y=t[u+g];if(y!==t[d+g]||y!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Ic(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function R0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function L0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}xi.prototype.ValueTypeName="";xi.prototype.TimeBufferType=Float32Array;xi.prototype.ValueBufferType=Float32Array;xi.prototype.DefaultInterpolation=qc;var fr=class extends xi{constructor(e,t,n){super(e,t,n)}};fr.prototype.ValueTypeName="bool";fr.prototype.ValueBufferType=Array;fr.prototype.DefaultInterpolation=Ha;fr.prototype.InterpolantFactoryMethodLinear=void 0;fr.prototype.InterpolantFactoryMethodSmooth=void 0;var oh=class extends xi{constructor(e,t,n,s){super(e,t,n,s)}};oh.prototype.ValueTypeName="color";var ah=class extends xi{constructor(e,t,n,s){super(e,t,n,s)}};ah.prototype.ValueTypeName="number";var lh=class extends dr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)ni.slerpFlat(r,0,o,c-a,o,c,l);return r}},al=class extends xi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new lh(this.times,this.values,this.getValueSize(),e)}};al.prototype.ValueTypeName="quaternion";al.prototype.InterpolantFactoryMethodSmooth=void 0;var pr=class extends xi{constructor(e,t,n){super(e,t,n)}};pr.prototype.ValueTypeName="string";pr.prototype.ValueBufferType=Array;pr.prototype.DefaultInterpolation=Ha;pr.prototype.InterpolantFactoryMethodLinear=void 0;pr.prototype.InterpolantFactoryMethodSmooth=void 0;var ch=class extends xi{constructor(e,t,n,s){super(e,t,n,s)}};ch.prototype.ValueTypeName="vector";var hh=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],g=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},M_=new hh,uh=class{constructor(e){this.manager=e!==void 0?e:M_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};uh.DEFAULT_MATERIAL_NAME="__DEFAULT";var ll=class extends Vn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ut(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},cl=class extends ll{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ut(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},qf=new Rt,I0=new $,D0=new $,dh=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new et(512,512),this.mapType=li,this.map=null,this.mapPass=null,this.matrix=new Rt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new hr,this._frameExtents=new et(1,1),this._viewportCount=1,this._viewports=[new Zt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;I0.setFromMatrixPosition(e.matrixWorld),t.position.copy(I0),D0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(D0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){qf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(qf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Fo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(qf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Dc=new $,Nc=new ni,us=new $,hl=class extends Vn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Rt,this.projectionMatrix=new Rt,this.projectionMatrixInverse=new Rt,this.coordinateSystem=Ai,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Dc,Nc,us),us.x===1&&us.y===1&&us.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Dc,Nc,us.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Dc,Nc,us),us.x===1&&us.y===1&&us.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Dc,Nc,us.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},lr=new $,N0=new et,k0=new et,ei=class extends hl{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=zo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ko*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return zo*2*Math.atan(Math.tan(ko*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){lr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(lr.x,lr.y).multiplyScalar(-e/lr.z),lr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(lr.x,lr.y).multiplyScalar(-e/lr.z)}getViewSize(e,t){return this.getViewBounds(e,N0,k0),t.subVectors(k0,N0)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ko*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var ul=class extends hl{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Jf=class extends dh{constructor(){super(new ul(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},dl=class extends ll{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.target=new Vn,this.shadow=new Jf}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Do=-90,No=1,Ho=class extends Vn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ei(Do,No,e,t);s.layers=this.layers,this.add(s);let r=new ei(Do,No,e,t);r.layers=this.layers,this.add(r);let o=new ei(Do,No,e,t);o.layers=this.layers,this.add(o);let a=new ei(Do,No,e,t);a.layers=this.layers,this.add(a);let l=new ei(Do,No,e,t);l.layers=this.layers,this.add(l);let c=new ei(Do,No,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ai)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Fo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},fh=class extends ei{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Rp="\\[\\]\\.:\\/",yS=new RegExp("["+Rp+"]","g"),Lp="[^"+Rp+"]",xS="[^"+Rp.replace("\\.","")+"]",bS=/((?:WC+[\/:])*)/.source.replace("WC",Lp),wS=/(WCOD+)?/.source.replace("WCOD",xS),SS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Lp),MS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Lp),TS=new RegExp("^"+bS+wS+SS+MS+"$"),ES=["material","materials","bones","map"],jf=class{constructor(e,t,n){let s=n||Xt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Xt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(yS,"")}static parseTrackName(e){let t=TS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ES.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){$e("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Xt.Composite=jf;Xt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Xt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Xt.prototype.GetterByBindingType=[Xt.prototype._getValue_direct,Xt.prototype._getValue_array,Xt.prototype._getValue_arrayElement,Xt.prototype._getValue_toArray];Xt.prototype.SetterByBindingTypeAndVersioning=[[Xt.prototype._setValue_direct,Xt.prototype._setValue_direct_setNeedsUpdate,Xt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_array,Xt.prototype._setValue_array_setNeedsUpdate,Xt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_arrayElement,Xt.prototype._setValue_arrayElement_setNeedsUpdate,Xt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_fromArray,Xt.prototype._setValue_fromArray_setNeedsUpdate,Xt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var bI=new Float32Array(1);var Wo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=_t(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(_t(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Up=class Up{constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};Up.prototype.isMatrix2=!0;var Qf=Up;var fl=class extends Hi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Ip(i,e,t,n){let s=AS(n);switch(t){case vp:return i*e;case wh:return i*e/s.components*s.byteLength;case Sh:return i*e/s.components*s.byteLength;case vr:return i*e*2/s.components*s.byteLength;case Mh:return i*e*2/s.components*s.byteLength;case yp:return i*e*3/s.components*s.byteLength;case Yi:return i*e*4/s.components*s.byteLength;case Th:return i*e*4/s.components*s.byteLength;case ml:case gl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case _l:case vl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ah:case Ph:return Math.max(i,16)*Math.max(e,8)/4;case Eh:case Ch:return Math.max(i,8)*Math.max(e,8)/2;case Rh:case Lh:case Dh:case Nh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Ih:case yl:case kh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Oh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Uh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Fh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Bh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case zh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Vh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Gh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Hh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Wh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Xh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case qh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case $h:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Yh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Kh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Zh:case Jh:case jh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Qh:case eu:return Math.ceil(i/4)*Math.ceil(e/4)*8;case xl:case tu:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function AS(i){switch(i){case li:case pp:return{byteLength:1,components:1};case Yo:case mp:case $i:return{byteLength:2,components:1};case xh:case bh:return{byteLength:2,components:4};case qi:case yh:case Ri:return{byteLength:4,components:1};case gp:case _p:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$e("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function q_(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function PS(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],y=u[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,u[d]=y)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let y=u[f];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var RS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,LS=`#ifdef USE_ALPHAHASH
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
#endif`,IS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,DS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,NS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,kS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,OS=`#ifdef USE_AOMAP
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
#endif`,US=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,FS=`#ifdef USE_BATCHING
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
#endif`,BS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,zS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,VS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,GS=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,HS=`#ifdef USE_IRIDESCENCE
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
#endif`,WS=`#ifdef USE_BUMPMAP
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
#endif`,XS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,qS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,$S=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,YS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,KS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ZS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,JS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,jS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,QS=`#define PI 3.141592653589793
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
} // validated`,eM=`vec3 transformedNormal = objectNormal;
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
#endif`,tM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,nM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,iM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,sM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,rM="gl_FragColor = linearToOutputTexel( gl_FragColor );",oM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,aM=`#ifdef USE_ENVMAP
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
#endif`,lM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,cM=`#ifdef USE_ENVMAP
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
#endif`,hM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,uM=`#ifdef USE_ENVMAP
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
#endif`,dM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,fM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,pM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,mM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,gM=`#ifdef USE_GRADIENTMAP
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
}`,_M=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,vM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,yM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,xM=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,bM=`#ifdef USE_ENVMAP
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
#endif`,wM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,SM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,MM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,TM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,EM=`PhysicalMaterial material;
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
#endif`,AM=`uniform sampler2D dfgLUT;
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
}`,CM=`
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
#endif`,PM=`#if defined( RE_IndirectDiffuse )
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
#endif`,RM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,LM=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,IM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,DM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,NM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,kM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,OM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,UM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,FM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,BM=`#if defined( USE_POINTS_UV )
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
#endif`,zM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,VM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,GM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,HM=`#if defined( USE_MORPHCOLORS )
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
#endif`,WM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,XM=`#ifdef USE_MORPHTARGETS
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
#endif`,qM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,$M=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,YM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,KM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ZM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,JM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,jM=`#ifdef USE_NORMALMAP
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
#endif`,QM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,e1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,t1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,n1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,i1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,s1=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,r1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,o1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,a1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,l1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,c1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,h1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,u1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,d1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,f1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,p1=`float getShadowMask() {
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
}`,m1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,g1=`#ifdef USE_SKINNING
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
#endif`,_1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,v1=`#ifdef USE_SKINNING
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
#endif`,y1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,x1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,b1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,w1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,S1=`#ifdef USE_TRANSMISSION
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
#endif`,M1=`#ifdef USE_TRANSMISSION
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
#endif`,T1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,E1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,A1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,C1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,P1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,R1=`uniform sampler2D t2D;
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
}`,L1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,I1=`uniform float backgroundBlurriness;
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
}`,D1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,N1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,k1=`#include <common>
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
}`,O1=`#if DEPTH_PACKING == 3200
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
}`,U1=`#define DISTANCE
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
}`,F1=`#define DISTANCE
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
}`,B1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,z1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,V1=`uniform float scale;
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
}`,G1=`uniform vec3 diffuse;
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
}`,H1=`#include <common>
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
}`,W1=`uniform vec3 diffuse;
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
}`,X1=`#define LAMBERT
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
}`,q1=`#define LAMBERT
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
}`,$1=`#define MATCAP
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
}`,Y1=`#define MATCAP
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
}`,K1=`#define NORMAL
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
}`,Z1=`#define NORMAL
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
}`,J1=`#define PHONG
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
}`,j1=`#define PHONG
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
}`,Q1=`#define STANDARD
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
}`,eT=`#define STANDARD
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
}`,tT=`#define TOON
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
}`,nT=`#define TOON
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
}`,iT=`uniform float size;
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
}`,sT=`uniform vec3 diffuse;
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
}`,rT=`#include <common>
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
}`,oT=`uniform vec3 color;
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
}`,aT=`uniform float rotation;
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
}`,lT=`uniform vec3 diffuse;
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
}`,ft={alphahash_fragment:RS,alphahash_pars_fragment:LS,alphamap_fragment:IS,alphamap_pars_fragment:DS,alphatest_fragment:NS,alphatest_pars_fragment:kS,aomap_fragment:OS,aomap_pars_fragment:US,batching_pars_vertex:FS,batching_vertex:BS,begin_vertex:zS,beginnormal_vertex:VS,bsdfs:GS,iridescence_fragment:HS,bumpmap_pars_fragment:WS,clipping_planes_fragment:XS,clipping_planes_pars_fragment:qS,clipping_planes_pars_vertex:$S,clipping_planes_vertex:YS,color_fragment:KS,color_pars_fragment:ZS,color_pars_vertex:JS,color_vertex:jS,common:QS,defaultnormal_vertex:eM,displacementmap_pars_vertex:tM,displacementmap_vertex:nM,emissivemap_fragment:iM,emissivemap_pars_fragment:sM,colorspace_fragment:rM,colorspace_pars_fragment:oM,envmap_fragment:aM,envmap_common_pars_fragment:lM,envmap_pars_fragment:cM,envmap_pars_vertex:hM,envmap_physical_pars_fragment:bM,envmap_vertex:uM,fog_vertex:dM,fog_pars_vertex:fM,fog_fragment:pM,fog_pars_fragment:mM,gradientmap_pars_fragment:gM,lightmap_pars_fragment:_M,lights_lambert_fragment:vM,lights_lambert_pars_fragment:yM,lights_pars_begin:xM,lights_toon_fragment:wM,lights_toon_pars_fragment:SM,lights_phong_fragment:MM,lights_phong_pars_fragment:TM,lights_physical_fragment:EM,lights_physical_pars_fragment:AM,lights_fragment_begin:CM,lights_fragment_maps:PM,lights_fragment_end:RM,lightprobes_pars_fragment:LM,logdepthbuf_fragment:IM,logdepthbuf_pars_fragment:DM,logdepthbuf_pars_vertex:NM,logdepthbuf_vertex:kM,map_fragment:OM,map_pars_fragment:UM,map_particle_fragment:FM,map_particle_pars_fragment:BM,metalnessmap_fragment:zM,metalnessmap_pars_fragment:VM,morphinstance_vertex:GM,morphcolor_vertex:HM,morphnormal_vertex:WM,morphtarget_pars_vertex:XM,morphtarget_vertex:qM,normal_fragment_begin:$M,normal_fragment_maps:YM,normal_pars_fragment:KM,normal_pars_vertex:ZM,normal_vertex:JM,normalmap_pars_fragment:jM,clearcoat_normal_fragment_begin:QM,clearcoat_normal_fragment_maps:e1,clearcoat_pars_fragment:t1,iridescence_pars_fragment:n1,opaque_fragment:i1,packing:s1,premultiplied_alpha_fragment:r1,project_vertex:o1,dithering_fragment:a1,dithering_pars_fragment:l1,roughnessmap_fragment:c1,roughnessmap_pars_fragment:h1,shadowmap_pars_fragment:u1,shadowmap_pars_vertex:d1,shadowmap_vertex:f1,shadowmask_pars_fragment:p1,skinbase_vertex:m1,skinning_pars_vertex:g1,skinning_vertex:_1,skinnormal_vertex:v1,specularmap_fragment:y1,specularmap_pars_fragment:x1,tonemapping_fragment:b1,tonemapping_pars_fragment:w1,transmission_fragment:S1,transmission_pars_fragment:M1,uv_pars_fragment:T1,uv_pars_vertex:E1,uv_vertex:A1,worldpos_vertex:C1,background_vert:P1,background_frag:R1,backgroundCube_vert:L1,backgroundCube_frag:I1,cube_vert:D1,cube_frag:N1,depth_vert:k1,depth_frag:O1,distance_vert:U1,distance_frag:F1,equirect_vert:B1,equirect_frag:z1,linedashed_vert:V1,linedashed_frag:G1,meshbasic_vert:H1,meshbasic_frag:W1,meshlambert_vert:X1,meshlambert_frag:q1,meshmatcap_vert:$1,meshmatcap_frag:Y1,meshnormal_vert:K1,meshnormal_frag:Z1,meshphong_vert:J1,meshphong_frag:j1,meshphysical_vert:Q1,meshphysical_frag:eT,meshtoon_vert:tT,meshtoon_frag:nT,points_vert:iT,points_frag:sT,shadow_vert:rT,shadow_frag:oT,sprite_vert:aT,sprite_frag:lT},Ie={common:{diffuse:{value:new ut(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new et(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ut(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ut(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new ut(16777215)},opacity:{value:1},center:{value:new et(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},vs={basic:{uniforms:$n([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:$n([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new ut(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:$n([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new ut(0)},specular:{value:new ut(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:$n([Ie.common,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.roughnessmap,Ie.metalnessmap,Ie.fog,Ie.lights,{emissive:{value:new ut(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:$n([Ie.common,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.gradientmap,Ie.fog,Ie.lights,{emissive:{value:new ut(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:$n([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:$n([Ie.points,Ie.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:$n([Ie.common,Ie.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:$n([Ie.common,Ie.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:$n([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:$n([Ie.sprite,Ie.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:$n([Ie.common,Ie.displacementmap,{referencePosition:{value:new $},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:$n([Ie.lights,Ie.fog,{color:{value:new ut(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};vs.physical={uniforms:$n([vs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new et(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new it},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new ut(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new et},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new ut(0)},specularColor:{value:new ut(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new et},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var iu={r:0,b:0,g:0},cT=new Rt,$_=new it;$_.set(-1,0,0,0,1,0,0,0,1);function hT(i,e,t,n,s,r){let o=new ut(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(x){let C=x.isScene===!0?x.background:null;if(C&&C.isTexture){let M=x.backgroundBlurriness>0;C=e.get(C,M)}return C}function g(x){let C=!1,M=f(x);M===null?p(o,a):M&&M.isColor&&(p(M,1),C=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(x,C){let M=f(C);M&&M.isCubeTexture?(c===void 0&&(c=new en(new ur(1,1,1),new ms({name:"BackgroundCubeMaterial",uniforms:Gr(vs.backgroundCube.uniforms),vertexShader:vs.backgroundCube.vertexShader,fragmentShader:vs.backgroundCube.fragmentShader,side:ii,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,T,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(cT.makeRotationFromEuler(C.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply($_),c.material.toneMapped=xt.getTransfer(M.colorSpace)!==Pt,(h!==M||u!==M.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=M,u=M.version,d=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new en(new ps(2,2),new ms({name:"BackgroundMaterial",uniforms:Gr(vs.background.uniforms),vertexShader:vs.background.vertexShader,fragmentShader:vs.background.fragmentShader,side:_r,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=xt.getTransfer(M.colorSpace)!==Pt,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||u!==M.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=M,u=M.version,d=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function p(x,C){x.getRGB(iu,Pp(i)),t.buffers.color.setClear(iu.r,iu.g,iu.b,C,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,C=1){o.set(x),a=C,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,p(o,a)},render:g,addToRenderList:y,dispose:m}}function uT(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(N,W,H,I,F){let q=!1,V=u(N,I,H,W);r!==V&&(r=V,c(r.object)),q=f(N,I,H,F),q&&g(N,I,H,F),F!==null&&e.update(F,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,M(N,W,H,I),F!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(F).buffer))}function l(){return i.createVertexArray()}function c(N){return i.bindVertexArray(N)}function h(N){return i.deleteVertexArray(N)}function u(N,W,H,I){let F=I.wireframe===!0,q=n[W.id];q===void 0&&(q={},n[W.id]=q);let V=N.isInstancedMesh===!0?N.id:0,le=q[V];le===void 0&&(le={},q[V]=le);let Z=le[H.id];Z===void 0&&(Z={},le[H.id]=Z);let Q=Z[F];return Q===void 0&&(Q=d(l()),Z[F]=Q),Q}function d(N){let W=[],H=[],I=[];for(let F=0;F<t;F++)W[F]=0,H[F]=0,I[F]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:W,enabledAttributes:H,attributeDivisors:I,object:N,attributes:{},index:null}}function f(N,W,H,I){let F=r.attributes,q=W.attributes,V=0,le=H.getAttributes();for(let Z in le)if(le[Z].location>=0){let ie=F[Z],de=q[Z];if(de===void 0&&(Z==="instanceMatrix"&&N.instanceMatrix&&(de=N.instanceMatrix),Z==="instanceColor"&&N.instanceColor&&(de=N.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;V++}return r.attributesNum!==V||r.index!==I}function g(N,W,H,I){let F={},q=W.attributes,V=0,le=H.getAttributes();for(let Z in le)if(le[Z].location>=0){let ie=q[Z];ie===void 0&&(Z==="instanceMatrix"&&N.instanceMatrix&&(ie=N.instanceMatrix),Z==="instanceColor"&&N.instanceColor&&(ie=N.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),F[Z]=de,V++}r.attributes=F,r.attributesNum=V,r.index=I}function y(){let N=r.newAttributes;for(let W=0,H=N.length;W<H;W++)N[W]=0}function p(N){m(N,0)}function m(N,W){let H=r.newAttributes,I=r.enabledAttributes,F=r.attributeDivisors;H[N]=1,I[N]===0&&(i.enableVertexAttribArray(N),I[N]=1),F[N]!==W&&(i.vertexAttribDivisor(N,W),F[N]=W)}function x(){let N=r.newAttributes,W=r.enabledAttributes;for(let H=0,I=W.length;H<I;H++)W[H]!==N[H]&&(i.disableVertexAttribArray(H),W[H]=0)}function C(N,W,H,I,F,q,V){V===!0?i.vertexAttribIPointer(N,W,H,F,q):i.vertexAttribPointer(N,W,H,I,F,q)}function M(N,W,H,I){y();let F=I.attributes,q=H.getAttributes(),V=W.defaultAttributeValues;for(let le in q){let Z=q[le];if(Z.location>=0){let Q=F[le];if(Q===void 0&&(le==="instanceMatrix"&&N.instanceMatrix&&(Q=N.instanceMatrix),le==="instanceColor"&&N.instanceColor&&(Q=N.instanceColor)),Q!==void 0){let ie=Q.normalized,de=Q.itemSize,ue=e.get(Q);if(ue===void 0)continue;let ee=ue.buffer,me=ue.type,ge=ue.bytesPerElement,ve=me===i.INT||me===i.UNSIGNED_INT||Q.gpuType===yh;if(Q.isInterleavedBufferAttribute){let _e=Q.data,Ge=_e.isInterleavedBuffer===!0?_e.stride:_e.itemSize,Ze=Q.offset;if(_e.isInstancedInterleavedBuffer||_e.isInstancedBufferAttribute){for(let Ue=0;Ue<Z.locationSize;Ue++)m(Z.location+Ue,_e.meshPerAttribute);N.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=_e.meshPerAttribute*_e.count)}else for(let Ue=0;Ue<Z.locationSize;Ue++)p(Z.location+Ue);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Ue=0;Ue<Z.locationSize;Ue++)C(Z.location+Ue,de/Z.locationSize,me,ie,Ge*ge,(Ze+de/Z.locationSize*Ue)*ge,ve)}else{if(Q.isInstancedBufferAttribute){for(let _e=0;_e<Z.locationSize;_e++)m(Z.location+_e,Q.meshPerAttribute);N.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let _e=0;_e<Z.locationSize;_e++)p(Z.location+_e);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let _e=0;_e<Z.locationSize;_e++)C(Z.location+_e,de/Z.locationSize,me,ie,de*ge,de/Z.locationSize*_e*ge,ve)}}else if(V!==void 0){let ie=V[le];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(Z.location,ie);break;case 3:i.vertexAttrib3fv(Z.location,ie);break;case 4:i.vertexAttrib4fv(Z.location,ie);break;default:i.vertexAttrib1fv(Z.location,ie)}}}}x()}function R(){z();for(let N in n){let W=n[N];for(let H in W){let I=W[H];for(let F in I){let q=I[F];for(let V in q)h(q[V].object),delete q[V];delete I[F]}}delete n[N]}}function T(N){if(n[N.id]===void 0)return;let W=n[N.id];for(let H in W){let I=W[H];for(let F in I){let q=I[F];for(let V in q)h(q[V].object),delete q[V];delete I[F]}}delete n[N.id]}function v(N){for(let W in n){let H=n[W];for(let I in H){let F=H[I];if(F[N.id]===void 0)continue;let q=F[N.id];for(let V in q)h(q[V].object),delete q[V];delete F[N.id]}}}function E(N){for(let W in n){let H=n[W],I=N.isInstancedMesh===!0?N.id:0,F=H[I];if(F!==void 0){for(let q in F){let V=F[q];for(let le in V)h(V[le].object),delete V[le];delete F[q]}delete H[I],Object.keys(H).length===0&&delete n[W]}}}function z(){k(),o=!0,r!==s&&(r=s,c(r.object))}function k(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:z,resetDefaultState:k,dispose:R,releaseStatesOfGeometry:T,releaseStatesOfObject:E,releaseStatesOfProgram:v,initAttributes:y,enableAttribute:p,disableUnusedAttributes:x}}function dT(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function fT(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==Yi&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let E=v===$i&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==li&&v!==Ri&&!E&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&($e("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&$e("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&$e("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),C=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),T=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:x,maxVaryings:C,maxFragmentUniforms:M,maxSamples:R,samples:T}}function pT(i){let e=this,t=null,n=0,s=!1,r=!1,o=new vi,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,y=u.clipIntersection,p=u.clipShadows,m=i.get(u);if(!s||g===null||g.length===0||r&&!p)r?h(null):c();else{let x=r?0:n,C=x*4,M=m.clippingState||null;l.value=M,M=h(g,d,C,f);for(let R=0;R!==C;++R)M[R]=t[R];m.clippingState=M,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,g){let y=u!==null?u.length:0,p=null;if(y!==0){if(p=l.value,g!==!0||p===null){let m=f+y*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(p===null||p.length<m)&&(p=new Float32Array(m));for(let C=0,M=f;C!==y;++C,M+=4)o.copy(u[C]).applyMatrix4(x,a),o.normal.toArray(p,M),p[M+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}var Sl=class extends yi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new il(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ur(5,5,5),r=new ms({name:"CubemapFromEquirect",uniforms:Gr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ii,blending:Fr});r.uniforms.tEquirect.value=t;let o=new en(s,r),a=t.minFilter;return t.minFilter===Xs&&(t.minFilter=ti),new Ho(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},T_=256,mT=3,gT=20,Y_=256,K_=16,_T=3,vT=new $,yT=new ut,ru=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ho(1,10,null),this._boxMesh=new en(new ur(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=vT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(yT));let p=new Ho(n,s,h);return p.position.copy(a),p.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=y,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=C_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=A_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(T_,Ep(e))}_fromTexture(e,t){e.mapping===zr||e.mapping===$o?this._setSize(e.image.length===0?T_:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=E_(e,!1,!1),n=Math.log2(e)-mT;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=E_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===zr||e.mapping===$o?(this._cubemapMaterial===null&&(this._cubemapMaterial=C_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=A_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=xT(),this._integrationMaterial=bT());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/K_);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-_T)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Y_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=wT());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function E_(i,e,t){return new Sl(i,{minFilter:Xs,generateMipmaps:e,type:$i,colorSpace:Wa,depthBuffer:t})}function Ml(i,e,t){return new ms({name:i,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:ii,blending:Fr,depthTest:!1,depthWrite:!1})}function xT(){return Ml("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Y_}u

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
	`)}function bT(){return Ml("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:K_}},`

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
	`)}function wT(){return Ml("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${gT}
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
	`)}function A_(){return Ml("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function C_(){return Ml("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function ST(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===gh||f===_h)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let y=new Sl(g.height);return y.fromEquirectangularTexture(i,d),e.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===gh||f===_h,y=f===zr||f===$o;if(g||y){let p=t.get(d),m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new ru(i)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{let x=d.image;return g&&x&&x.height>0||y&&x&&l(x)?(n===null&&(n=new ru(i)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function a(d,f){return f===gh?d.mapping=zr:f===_h&&(d.mapping=$o),d}function l(d){let f=0,g=6;for(let y=0;y<g;y++)d[y]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function MT(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Va("WebGLRenderer: "+n+" extension not supported."),s}}}function TT(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function h(g){let y=g.attributes;for(let p in y)e.update(y[p],i.ARRAY_BUFFER)}function u(g){let y=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let x=y!==null?y.array.length:p.array.length/3-1,C=p.count>=65535?ja:Ja,M=new C(Math.ceil(x/3)*6,1),R=M.array;if(y!==null){let v=y.array;m=y.version;for(let E=0,z=0;E<x;E+=3){let k=v[E+0],N=v[E+1],W=v[E+2];R[z++]=k,R[z++]=N,R[z++]=N,R[z++]=W,R[z++]=W,R[z++]=k}}else{m=p.version;for(let v=0,E=0;v<x;v+=3){let z=v+0,k=v+1,N=v+2;R[E++]=z,R[E++]=k,R[E++]=k,R[E++]=N,R[E++]=N,R[E++]=z}}M.version=m;let T=r.get(g);T&&e.remove(T),r.set(g,M)}function d(g){let y=r.get(g);if(y){let p=g.index;p!==null&&y.version<p.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function ET(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let y=0;for(let p=0;p<f;p++)y+=d[p];t.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function AT(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:nt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function CT(i,e,t){let n=new WeakMap,s=new Zt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let z=function(){v.dispose(),n.delete(a),a.removeEventListener("dispose",z)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],C=0;f===!0&&(C=1),g===!0&&(C=2),y===!0&&(C=3);let M=a.attributes.position.count*C,R=1;M>e.maxTextureSize&&(R=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let T=new Float32Array(M*R*4*u),v=new $a(T,M,R,u);v.type=Ri,v.needsUpdate=!0;let E=C*4;for(let k=0;k<u;k++){let N=p[k],W=m[k],H=x[k],I=M*R*4*k;for(let F=0;F<N.count;F++){let q=F*E;f===!0&&(s.fromBufferAttribute(N,F),T[I+q+0]=s.x,T[I+q+1]=s.y,T[I+q+2]=s.z,T[I+q+3]=0),g===!0&&(s.fromBufferAttribute(W,F),T[I+q+4]=s.x,T[I+q+5]=s.y,T[I+q+6]=s.z,T[I+q+7]=0),y===!0&&(s.fromBufferAttribute(H,F),T[I+q+8]=s.x,T[I+q+9]=s.y,T[I+q+10]=s.z,T[I+q+11]=H.itemSize===4?s.w:1)}}d={count:u,texture:v,size:new et(M,R)},n.set(a,d),a.addEventListener("dispose",z)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function PT(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var RT={[op]:"LINEAR_TONE_MAPPING",[ap]:"REINHARD_TONE_MAPPING",[lp]:"CINEON_TONE_MAPPING",[cp]:"ACES_FILMIC_TONE_MAPPING",[up]:"AGX_TONE_MAPPING",[dp]:"NEUTRAL_TONE_MAPPING",[hp]:"CUSTOM_TONE_MAPPING"};function LT(i,e,t,n,s,r){let o=new yi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Gn;h.setAttribute("position",new Fn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Fn([0,2,0,0,2,0],2));let u=new Qc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new en(h,u),f=new ul(-1,1,1,-1,0,1),g=null,y=null,p=!1,m,x=null,C=[],M=!1;this.setSize=function(R,T){o.setSize(R,T),a!==null&&a.setSize(R,T),l!==null&&l.setSize(R,T);for(let v=0;v<C.length;v++){let E=C[v];E.setSize&&E.setSize(R,T)}},this.setEffects=function(R){C=R,M=C.length>0&&C[0].isRenderPass===!0;let T=o.width,v=o.height;C.length>0&&a===null&&(a=new yi(T,v,{type:$i,depthBuffer:!1,stencilBuffer:!1}),l=new yi(T,v,{type:$i,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&C.some(z=>z.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Ws(T,v),r===!0&&(c.format=qs,c.type=Vr)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let z=0;z<C.length;z++){let k=C[z];k.setSize&&k.setSize(T,v),E&&k.needsDepthTexture===!0&&k.setDepthTexture&&k.setDepthTexture(c)}},this.begin=function(R,T){if(p||R.toneMapping===gs&&C.length===0)return!1;if(x=T,T!==null){let v=T.width,E=T.height;(o.width!==v||o.height!==E)&&this.setSize(v,E)}return M===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=gs,!0},this.hasRenderPass=function(){return M},this.end=function(R,T){R.toneMapping=m,p=!0;let v=o,E=a;for(let z=0;z<C.length;z++){let k=C[z];k.enabled!==!1&&(k.render(R,E,v,T),k.needsSwap!==!1&&(v=E,E=E===a?l:a))}if(g!==R.outputColorSpace||y!==R.toneMapping){g=R.outputColorSpace,y=R.toneMapping,u.defines={},xt.getTransfer(g)===Pt&&(u.defines.SRGB_TRANSFER="");let z=RT[y];z&&(u.defines[z]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,R.setRenderTarget(x),R.render(d,f),x=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Z_=new oi,J_=new Ws(1,1),j_=new sl(1),Q_=new $a,ev=new Kc,tv=new il,P_=[],R_=[],L_=new Float32Array(16),I_=new Float32Array(9),D_=new Float32Array(4);function Jo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=P_[s];if(r===void 0&&(r=new Float32Array(s),P_[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Tn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function En(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function au(i,e){let t=R_[e];t===void 0&&(t=new Int32Array(e),R_[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function IT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function DT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;i.uniform2fv(this.addr,e),En(t,e)}}function NT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Tn(t,e))return;i.uniform3fv(this.addr,e),En(t,e)}}function kT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;i.uniform4fv(this.addr,e),En(t,e)}}function OT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Tn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),En(t,e)}else{if(Tn(t,n))return;D_.set(n),i.uniformMatrix2fv(this.addr,!1,D_),En(t,n)}}function UT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Tn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),En(t,e)}else{if(Tn(t,n))return;I_.set(n),i.uniformMatrix3fv(this.addr,!1,I_),En(t,n)}}function FT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Tn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),En(t,e)}else{if(Tn(t,n))return;L_.set(n),i.uniformMatrix4fv(this.addr,!1,L_),En(t,n)}}function BT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function zT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;i.uniform2iv(this.addr,e),En(t,e)}}function VT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Tn(t,e))return;i.uniform3iv(this.addr,e),En(t,e)}}function GT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;i.uniform4iv(this.addr,e),En(t,e)}}function HT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function WT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;i.uniform2uiv(this.addr,e),En(t,e)}}function XT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Tn(t,e))return;i.uniform3uiv(this.addr,e),En(t,e)}}function qT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;i.uniform4uiv(this.addr,e),En(t,e)}}function lu(i){return i.version===0&&(i.compareFunction=wp,i.needsUpdate=!0),i}function $T(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=lu(J_):r=Z_,t.setTexture2D(e||r,s)}function YT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||ev,s)}function KT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=lu(j_):r=tv,t.setTextureCube(e||r,s)}function ZT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Q_,s)}function JT(i){switch(i){case 5126:return IT;case 35664:return DT;case 35665:return NT;case 35666:return kT;case 35674:return OT;case 35675:return UT;case 35676:return FT;case 5124:case 35670:return BT;case 35667:case 35671:return zT;case 35668:case 35672:return VT;case 35669:case 35673:return GT;case 5125:return HT;case 36294:return WT;case 36295:return XT;case 36296:return qT;case 35678:case 36198:case 36298:case 36306:case 35682:return $T;case 35679:case 36299:case 36307:return YT;case 35680:case 36300:case 36308:case 36293:return KT;case 36289:case 36303:case 36311:case 36292:return ZT}}function jT(i,e){i.uniform1fv(this.addr,e)}function QT(i,e){let t=Jo(e,this.size,2);i.uniform2fv(this.addr,t)}function eE(i,e){let t=Jo(e,this.size,3);i.uniform3fv(this.addr,t)}function tE(i,e){let t=Jo(e,this.size,4);i.uniform4fv(this.addr,t)}function nE(i,e){let t=Jo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function iE(i,e){let t=Jo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function sE(i,e){let t=Jo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function rE(i,e){i.uniform1iv(this.addr,e)}function oE(i,e){i.uniform2iv(this.addr,e)}function aE(i,e){i.uniform3iv(this.addr,e)}function lE(i,e){i.uniform4iv(this.addr,e)}function cE(i,e){i.uniform1uiv(this.addr,e)}function hE(i,e){i.uniform2uiv(this.addr,e)}function uE(i,e){i.uniform3uiv(this.addr,e)}function dE(i,e){i.uniform4uiv(this.addr,e)}function fE(i,e,t){let n=this.cache,s=e.length,r=au(t,s);Tn(n,r)||(i.uniform1iv(this.addr,r),En(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=lu(J_):o=Z_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function pE(i,e,t){let n=this.cache,s=e.length,r=au(t,s);Tn(n,r)||(i.uniform1iv(this.addr,r),En(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||ev,r[o])}function mE(i,e,t){let n=this.cache,s=e.length,r=au(t,s);Tn(n,r)||(i.uniform1iv(this.addr,r),En(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=lu(j_):o=tv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function gE(i,e,t){let n=this.cache,s=e.length,r=au(t,s);Tn(n,r)||(i.uniform1iv(this.addr,r),En(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Q_,r[o])}function _E(i){switch(i){case 5126:return jT;case 35664:return QT;case 35665:return eE;case 35666:return tE;case 35674:return nE;case 35675:return iE;case 35676:return sE;case 5124:case 35670:return rE;case 35667:case 35671:return oE;case 35668:case 35672:return aE;case 35669:case 35673:return lE;case 5125:return cE;case 36294:return hE;case 36295:return uE;case 36296:return dE;case 35678:case 36198:case 36298:case 36306:case 35682:return fE;case 35679:case 36299:case 36307:return pE;case 35680:case 36300:case 36308:case 36293:return mE;case 36289:case 36303:case 36311:case 36292:return gE}}var zp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=JT(t.type)}},Vp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=_E(t.type)}},Gp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Fp=/(\w+)(\])?(\[|\.)?/g;function N_(i,e){i.seq.push(e),i.map[e.id]=e}function vE(i,e,t){let n=i.name,s=n.length;for(Fp.lastIndex=0;;){let r=Fp.exec(n),o=Fp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){N_(t,c===void 0?new zp(a,i,e):new Vp(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Gp(a),N_(t,u)),t=u}}}var Zo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);vE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function k_(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var yE=37297,xE=0;function bE(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var O_=new it;function wE(i){xt._getMatrix(O_,xt.workingColorSpace,i);let e=`mat3( ${O_.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(i)){case Xa:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return $e("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function U_(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+bE(i.getShaderSource(e),a)}else return r}function SE(i,e){let t=wE(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var ME={[op]:"Linear",[ap]:"Reinhard",[lp]:"Cineon",[cp]:"ACESFilmic",[up]:"AgX",[dp]:"Neutral",[hp]:"Custom"};function TE(i,e){let t=ME[e];return t===void 0?($e("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var su=new $;function EE(){xt.getLuminanceCoefficients(su);let i=su.x.toFixed(4),e=su.y.toFixed(4),t=su.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function AE(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(wl).join(`
`)}function CE(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function PE(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function wl(i){return i!==""}function F_(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function B_(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var RE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Hp(i){return i.replace(RE,LE)}function LE(i,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Hp(t)}var IE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function z_(i){return i.replace(IE,DE)}function DE(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function V_(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var NE={[Ur]:"SHADOWMAP_TYPE_PCF",[Xo]:"SHADOWMAP_TYPE_VSM"};function kE(i){return NE[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var OE={[$o]:"ENVMAP_MODE_REFRACTION"};function UE(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":OE[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var FE={[mh]:"ENVMAP_BLENDING_MULTIPLY",[i_]:"ENVMAP_BLENDING_MIX",[s_]:"ENVMAP_BLENDING_ADD"};function BE(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":FE[i.combine]||"ENVMAP_BLENDING_NONE"}function zE(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=kE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=UE(t),u=BE(t),d=AE(t),f=CE(r),g=s.createProgram(),y,p,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(wl).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(wl).join(`
`),p.length>0&&(p+=`
`)):(y=[V_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(wl).join(`
`),p=[V_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==gs?"#define TONE_MAPPING":"",t.toneMapping!==gs?ft.tonemapping_pars_fragment:"",t.toneMapping!==gs?TE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,SE("linearToOutputTexel",t.outputColorSpace),EE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(wl).join(`
`)),o=Hp(o),o=F_(o,t),o=B_(o,t),a=Hp(a),a=F_(a,t),a=B_(a,t),o=z_(o),a=z_(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",t.glslVersion===Sp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Sp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let x=m+y+o,C=m+p+a,M=k_(s,s.VERTEX_SHADER,x),R=k_(s,s.FRAGMENT_SHADER,C);s.attachShader(g,M),s.attachShader(g,R),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function T(k){if(i.debug.checkShaderErrors){let N=s.getProgramInfoLog(g)||"",W=s.getShaderInfoLog(M)||"",H=s.getShaderInfoLog(R)||"",I=N.trim(),F=W.trim(),q=H.trim(),V=!0,le=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(V=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,M,R);else{let Z=U_(s,M,"vertex"),Q=U_(s,R,"fragment");nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+k.name+`
Material Type: `+k.type+`

Program Info Log: `+I+`
`+Z+`
`+Q)}else I!==""?$e("WebGLProgram: Program Info Log:",I):(F===""||q==="")&&(le=!1);le&&(k.diagnostics={runnable:V,programLog:I,vertexShader:{log:F,prefix:y},fragmentShader:{log:q,prefix:p}})}s.deleteShader(M),s.deleteShader(R),v=new Zo(s,g),E=PE(s,g)}let v;this.getUniforms=function(){return v===void 0&&T(this),v};let E;this.getAttributes=function(){return E===void 0&&T(this),E};let z=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return z===!1&&(z=s.getProgramParameter(g,yE)),z},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=xE++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=M,this.fragmentShader=R,this}var VE=0,Wp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Xp(e),t.set(e,n)),n}},Xp=class{constructor(e){this.id=VE++,this.code=e,this.usedTimes=0}};function GE(i){return i===vr||i===yl||i===xl}function HE(i,e,t,n,s,r){let o=new Ya,a=new Wp,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function g(v,E,z,k,N,W){let H=k.fog,I=N.geometry,F=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?k.environment:null,q=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,V=e.get(v.envMap||F,q),le=d[v.type],Z=n.precision;v.precision!==null&&(Z=n.getMaxPrecision(v.precision),Z!==v.precision&&$e("WebGLProgram.getParameters:",v.precision,"not supported, using",Z,"instead."));let Q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ie=Q!==void 0?Q.length:0,de=0;I.morphAttributes.position!==void 0&&(de=1),I.morphAttributes.normal!==void 0&&(de=2),I.morphAttributes.color!==void 0&&(de=3);let ue,ee,me,ge;if(le){let Ce=vs[le];ue=Ce.vertexShader,ee=Ce.fragmentShader}else{ue=v.vertexShader,ee=v.fragmentShader;let Ce=a.getVertexShaderStage(v),ht=a.getFragmentShaderStage(v);a.update(v,Ce,ht),me=Ce.id,ge=ht.id}let ve=i.getRenderTarget(),_e=i.state.buffers.depth.getReversed(),Ge=N.isInstancedMesh===!0,Ze=N.isBatchedMesh===!0,Ue=!!v.map,st=!!v.matcap,ct=!!V,rt=ct&&V.isPMREMTexture===!0,Yt=!!v.aoMap,zt=!!v.lightMap,dn=!!v.bumpMap&&v.wireframe===!1,kt=!!v.normalMap,Rn=!!v.displacementMap,wt=!!v.emissiveMap,Sn=!!v.metalnessMap,nn=!!v.roughnessMap,fn=v.anisotropy>0,U=v.clearcoat>0,Pe=v.diffuseRoughness>0,Ye=v.dispersion>0,lt=v.retroreflectivity>0,Me=v.iridescence>0,Ut=v.sheen>0,He=v.transmission>0,qe=fn&&!!v.anisotropyMap,P=U&&!!v.clearcoatMap,b=U&&!!v.clearcoatNormalMap,X=U&&!!v.clearcoatRoughnessMap,he=Pe&&!!v.diffuseRoughnessMap,oe=Me&&!!v.iridescenceMap,xe=Me&&!!v.iridescenceThicknessMap,be=Ut&&!!v.sheenColorMap,te=Ut&&!!v.sheenRoughnessMap,se=!!v.specularMap,pe=!!v.specularColorMap,O=!!v.specularIntensityMap,re=He&&!!v.transmissionMap,ne=He&&!!v.thicknessMap,Te=!!v.gradientMap,ye=!!v.alphaMap,Se=v.alphaTest>0,We=!!v.alphaHash,je=!!v.extensions,ce=gs;v.toneMapped&&(ve===null||ve.isXRRenderTarget===!0)&&(ce=i.toneMapping);let Be=rt?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,Qe={shaderID:le,shaderType:v.type,shaderName:v.name,vertexShader:ue,fragmentShader:ee,defines:v.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:Z,batching:Ze,batchingColor:Ze&&N._colorsTexture!==null,instancing:Ge,instancingColor:Ge&&N.instanceColor!==null,instancingMorph:Ge&&N.morphTexture!==null,outputColorSpace:ve===null?i.outputColorSpace:ve.isXRRenderTarget===!0?ve.texture.colorSpace:xt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Ue,matcap:st,envMap:ct,envMapMode:ct&&V.mapping,envMapPMREM:rt,envMapMaxLod:rt?Be.length-1:null,envMapSize:rt?Be[0].width:null,aoMap:Yt,lightMap:zt,bumpMap:dn,normalMap:kt,displacementMap:Rn,emissiveMap:wt,normalMapObjectSpace:kt&&v.normalMapType===a_,normalMapTangentSpace:kt&&v.normalMapType===nu,packedNormalMap:kt&&v.normalMapType===nu&&GE(v.normalMap.format),metalnessMap:Sn,roughnessMap:nn,anisotropy:fn,anisotropyMap:qe,clearcoat:U,clearcoatMap:P,clearcoatNormalMap:b,clearcoatRoughnessMap:X,diffuseRoughness:Pe,diffuseRoughnessMap:he,dispersion:Ye,retroreflection:lt,iridescence:Me,iridescenceMap:oe,iridescenceThicknessMap:xe,sheen:Ut,sheenColorMap:be,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:O,transmission:He,transmissionMap:re,thicknessMap:ne,gradientMap:Te,opaque:v.transparent===!1&&v.blending===qo&&v.alphaToCoverage===!1,alphaMap:ye,alphaTest:Se,alphaHash:We,combine:v.combine,mapUv:Ue&&f(v.map.channel),aoMapUv:Yt&&f(v.aoMap.channel),lightMapUv:zt&&f(v.lightMap.channel),bumpMapUv:dn&&f(v.bumpMap.channel),normalMapUv:kt&&f(v.normalMap.channel),displacementMapUv:Rn&&f(v.displacementMap.channel),emissiveMapUv:wt&&f(v.emissiveMap.channel),metalnessMapUv:Sn&&f(v.metalnessMap.channel),roughnessMapUv:nn&&f(v.roughnessMap.channel),anisotropyMapUv:qe&&f(v.anisotropyMap.channel),clearcoatMapUv:P&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:b&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:be&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(v.sheenRoughnessMap.channel),specularMapUv:se&&f(v.specularMap.channel),specularColorMapUv:pe&&f(v.specularColorMap.channel),specularIntensityMapUv:O&&f(v.specularIntensityMap.channel),transmissionMapUv:re&&f(v.transmissionMap.channel),thicknessMapUv:ne&&f(v.thicknessMap.channel),alphaMapUv:ye&&f(v.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(kt||fn),vertexNormals:!!I.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!I.attributes.uv&&(Ue||ye),fog:!!H,useFog:v.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||I.attributes.normal===void 0&&kt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:_e,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:W.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&z.length>0,shadowMapType:i.shadowMap.type,toneMapping:ce,decodeVideoTexture:Ue&&v.map.isVideoTexture===!0&&xt.getTransfer(v.map.colorSpace)===Pt,decodeVideoTextureEmissive:wt&&v.emissiveMap.isVideoTexture===!0&&xt.getTransfer(v.emissiveMap.colorSpace)===Pt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===ai,flipSided:v.side===ii,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:je&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&v.extensions.multiDraw===!0||Ze)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return Qe.vertexUv1s=l.has(1),Qe.vertexUv2s=l.has(2),Qe.vertexUv3s=l.has(3),l.clear(),Qe}function y(v){let E=[];if(v.shaderID?E.push(v.shaderID):(E.push(v.customVertexShaderID),E.push(v.customFragmentShaderID)),v.defines!==void 0)for(let z in v.defines)E.push(z),E.push(v.defines[z]);return v.isRawShaderMaterial===!1&&(p(E,v),m(E,v),E.push(i.outputColorSpace)),E.push(v.customProgramCacheKey),E.join()}function p(v,E){v.push(E.precision),v.push(E.outputColorSpace),v.push(E.envMapMode),v.push(E.envMapPMREM),v.push(E.envMapMaxLod),v.push(E.envMapSize),v.push(E.mapUv),v.push(E.alphaMapUv),v.push(E.lightMapUv),v.push(E.aoMapUv),v.push(E.bumpMapUv),v.push(E.normalMapUv),v.push(E.displacementMapUv),v.push(E.emissiveMapUv),v.push(E.metalnessMapUv),v.push(E.roughnessMapUv),v.push(E.anisotropyMapUv),v.push(E.clearcoatMapUv),v.push(E.clearcoatNormalMapUv),v.push(E.clearcoatRoughnessMapUv),v.push(E.diffuseRoughnessMapUv),v.push(E.iridescenceMapUv),v.push(E.iridescenceThicknessMapUv),v.push(E.sheenColorMapUv),v.push(E.sheenRoughnessMapUv),v.push(E.specularMapUv),v.push(E.specularColorMapUv),v.push(E.specularIntensityMapUv),v.push(E.transmissionMapUv),v.push(E.thicknessMapUv),v.push(E.combine),v.push(E.fogExp2),v.push(E.sizeAttenuation),v.push(E.morphTargetsCount),v.push(E.numSunLights),v.push(E.numDirLights),v.push(E.numPointLights),v.push(E.numSpotLights),v.push(E.numSpotLightMaps),v.push(E.numHemiLights),v.push(E.numRectAreaLights),v.push(E.numSunLightShadows),v.push(E.numDirLightShadows),v.push(E.numPointLightShadows),v.push(E.numSpotLightShadows),v.push(E.numSpotLightShadowsWithMaps),v.push(E.numLightProbes),v.push(E.numLightProbeGrids),v.push(E.shadowMapType),v.push(E.toneMapping),v.push(E.numClippingPlanes),v.push(E.numClipIntersection),v.push(E.depthPacking)}function m(v,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function x(v){let E=d[v.type],z;if(E){let k=vs[E];z=w_.clone(k.uniforms)}else z=v.uniforms;return z}function C(v,E){let z=h.get(E);return z!==void 0?++z.usedTimes:(z=new zE(i,E,v,s),c.push(z),h.set(E,z)),z}function M(v){if(--v.usedTimes===0){let E=c.indexOf(v);c[E]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function R(v){a.remove(v)}function T(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:x,acquireProgram:C,releaseProgram:M,releaseShaderCache:R,programs:c,dispose:T}}function WE(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function XE(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function G_(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function H_(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,y,p,m){let x=i[e];return x===void 0?(x={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:p,group:m},i[e]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=g,x.materialVariant=o(d),x.groupOrder=y,x.renderOrder=d.renderOrder,x.z=p,x.group=m),e++,x}function l(d,f,g,y,p,m,x){x.reversedDepth===!0&&(p=-p);let C=a(d,f,g,y,p,m);g.transmission>0?n.push(C):g.transparent===!0?s.push(C):t.push(C)}function c(d,f,g,y,p,m){let x=a(d,f,g,y,p,m);g.transmission>0?n.unshift(x):g.transparent===!0?s.unshift(x):t.unshift(x)}function h(d,f){t.length>1&&t.sort(d||XE),n.length>1&&n.sort(f||G_),s.length>1&&s.sort(f||G_)}function u(){for(let d=e,f=i.length;d<f;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function qE(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new H_,i.set(n,[o])):s>=r.length?(o=new H_,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function $E(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new $,color:new ut};break;case"SpotLight":t={position:new $,direction:new $,color:new ut,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new $,color:new ut,distance:0,decay:0};break;case"HemisphereLight":t={direction:new $,skyColor:new ut,groundColor:new ut};break;case"RectAreaLight":t={color:new ut,position:new $,halfWidth:new $,halfHeight:new $};break}return i[e.id]=t,t}}}function YE(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new et};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new et};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new et,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var KE=0;function ZE(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function JE(i){let e=new $E,t=YE(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new $);let s=new $,r=new Rt,o=new Rt;function a(c){let h=0,u=0,d=0;for(let W=0;W<9;W++)n.probe[W].set(0,0,0);let f=0,g=0,y=0,p=0,m=0,x=0,C=0,M=0,R=0,T=0,v=0,E=0,z=0,k=0;c.sort(ZE);for(let W=0,H=c.length;W<H;W++){let I=c[W],F=I.color,q=I.intensity,V=I.distance,le=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===vr?le=I.shadow.map.texture:le=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=F.r*q,u+=F.g*q,d+=F.b*q;else if(I.isLightProbe){for(let Z=0;Z<9;Z++)n.probe[Z].addScaledVector(I.sh.coefficients[Z],q);k++}else if(I.isSunLight){let Z=e.get(I);if(Z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=ie,n.sunShadowMap[g]=le;let de=Q.getViewportCount();for(let ue=0;ue<de;ue++)n.sunShadowMatrix[y+ue]=Q.getMatrix(ue),n.sunShadowCascade[y+ue]=Q._cascadeData[ue];y+=de,g++}n.sun[f]=Z,f++}else if(I.isDirectionalLight){let Z=e.get(I);if(Z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.directionalShadow[p]=ie,n.directionalShadowMap[p]=le,n.directionalShadowMatrix[p]=I.shadow.matrix,R++}n.directional[p]=Z,p++}else if(I.isSpotLight){let Z=e.get(I);Z.position.setFromMatrixPosition(I.matrixWorld),Z.color.copy(F).multiplyScalar(q),Z.distance=V,Z.coneCos=Math.cos(I.angle),Z.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),Z.decay=I.decay,n.spot[x]=Z;let Q=I.shadow;if(I.map&&(n.spotLightMap[E]=I.map,E++,Q.updateMatrices(I),I.castShadow&&z++),n.spotLightMatrix[x]=Q.matrix,I.castShadow){let ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.spotShadow[x]=ie,n.spotShadowMap[x]=le,v++}x++}else if(I.isRectAreaLight){let Z=e.get(I);Z.color.copy(F).multiplyScalar(q),Z.halfWidth.set(I.width*.5,0,0),Z.halfHeight.set(0,I.height*.5,0),n.rectArea[C]=Z,C++}else if(I.isPointLight){let Z=e.get(I);if(Z.color.copy(I.color).multiplyScalar(I.intensity),Z.distance=I.distance,Z.decay=I.decay,I.castShadow){let Q=I.shadow,ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,n.pointShadow[m]=ie,n.pointShadowMap[m]=le,n.pointShadowMatrix[m]=I.shadow.matrix,T++}n.point[m]=Z,m++}else if(I.isHemisphereLight){let Z=e.get(I);Z.skyColor.copy(I.color).multiplyScalar(q),Z.groundColor.copy(I.groundColor).multiplyScalar(q),n.hemi[M]=Z,M++}}C>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ie.LTC_FLOAT_1,n.rectAreaLTC2=Ie.LTC_FLOAT_2):(n.rectAreaLTC1=Ie.LTC_HALF_1,n.rectAreaLTC2=Ie.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let N=n.hash;(N.sunLength!==f||N.directionalLength!==p||N.pointLength!==m||N.spotLength!==x||N.rectAreaLength!==C||N.hemiLength!==M||N.numSunShadows!==g||N.numDirectionalShadows!==R||N.numPointShadows!==T||N.numSpotShadows!==v||N.numSpotMaps!==E||N.numLightProbes!==k)&&(n.sun.length=f,n.directional.length=p,n.spot.length=x,n.rectArea.length=C,n.point.length=m,n.hemi.length=M,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=T,n.pointShadowMap.length=T,n.pointShadowMatrix.length=T,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+E-z,n.spotLightMap.length=E,n.numSpotLightShadowsWithMaps=z,n.numLightProbes=k,N.sunLength=f,N.directionalLength=p,N.pointLength=m,N.spotLength=x,N.rectAreaLength=C,N.hemiLength=M,N.numSunShadows=g,N.numDirectionalShadows=R,N.numPointShadows=T,N.numSpotShadows=v,N.numSpotMaps=E,N.numLightProbes=k,n.version=KE++)}function l(c,h){let u=0,d=0,f=0,g=0,y=0,p=0,m=h.matrixWorldInverse;for(let x=0,C=c.length;x<C;x++){let M=c[x];if(M.isSunLight){let R=n.sun[u];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(m),u++}else if(M.isDirectionalLight){let R=n.directional[d];R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),d++}else if(M.isSpotLight){let R=n.spot[g];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),g++}else if(M.isRectAreaLight){let R=n.rectArea[y];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(M.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(M.width*.5,0,0),R.halfHeight.set(0,M.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),y++}else if(M.isPointLight){let R=n.point[f];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(m),f++}else if(M.isHemisphereLight){let R=n.hemi[p];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:n}}function W_(i){let e=new JE(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function jE(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new W_(i),e.set(s,[a])):r>=o.length?(a=new W_(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var QE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,eA=`uniform sampler2D shadow_pass;
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
}`,tA=[new $(1,0,0),new $(-1,0,0),new $(0,1,0),new $(0,-1,0),new $(0,0,1),new $(0,0,-1)],nA=[new $(0,-1,0),new $(0,-1,0),new $(0,0,1),new $(0,0,-1),new $(0,-1,0),new $(0,-1,0)],X_=new Rt,bl=new $,Bp=new $;function iA(i,e,t){let n=new hr,s=new et,r=new et,o=new Zt,a=new eh,l=new th,c={},h=t.maxTextureSize,u={[_r]:ii,[ii]:_r,[ai]:ai},d=new ms({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new et},radius:{value:4}},vertexShader:QE,fragmentShader:eA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Gn;g.setAttribute("position",new Un(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new en(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ur;let m=this.type;this.render=function(T,v,E){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||T.length===0)return;this.type===F0&&($e("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ur);let z=i.getRenderTarget(),k=i.getActiveCubeFace(),N=i.getActiveMipmapLevel(),W=i.state;W.setBlending(Fr),W.buffers.depth.getReversed()===!0?W.buffers.color.setClear(0,0,0,0):W.buffers.color.setClear(1,1,1,1),W.buffers.depth.setTest(!0),W.setScissorTest(!1);let H=m!==this.type;H&&v.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(F=>F.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,F=T.length;I<F;I++){let q=T[I],V=q.shadow;if(V===void 0){$e("WebGLShadowMap:",q,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let le=V.getFrameExtents();s.multiply(le),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/le.x),s.x=r.x*le.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/le.y),s.y=r.y*le.y,V.mapSize.y=r.y));let Z=i.state.buffers.depth.getReversed();if(V.camera._reversedDepth=Z,V.map===null||H===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Xo){if(q.isPointLight){$e("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new yi(s.x,s.y,{format:vr,type:$i,minFilter:ti,magFilter:ti,generateMipmaps:!1}),V.map.texture.name=q.name+".shadowMap",V.map.depthTexture=new Ws(s.x,s.y,Ri),V.map.depthTexture.name=q.name+".shadowMapDepth",V.map.depthTexture.format=zs,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=yn,V.map.depthTexture.magFilter=yn}else q.isPointLight?(V.map=new Sl(s.x),V.map.depthTexture=new sl(s.x,qi)):(V.map=new yi(s.x,s.y),V.map.depthTexture=new Ws(s.x,s.y,qi)),V.map.depthTexture.name=q.name+".shadowMap",V.map.depthTexture.format=zs,this.type===Ur?(V.map.depthTexture.compareFunction=Z?bp:xp,V.map.depthTexture.minFilter=ti,V.map.depthTexture.magFilter=ti):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=yn,V.map.depthTexture.magFilter=yn);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();q.isPointLight!==!0&&V.updateMatrices(q,E);let ie=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:E.layers;for(let de=0;de<Q;de++){let ue=V.getCamera(de);if(q.isPointLight){let ee=V.camera,me=V.matrix,ge=q.distance||ee.far;ge!==ee.far&&(ee.far=ge,ee.updateProjectionMatrix()),bl.setFromMatrixPosition(q.matrixWorld),ee.position.copy(bl),Bp.copy(ee.position),Bp.add(tA[de]),ee.up.copy(nA[de]),ee.lookAt(Bp),ee.updateMatrixWorld(),me.makeTranslation(-bl.x,-bl.y,-bl.z),X_.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),V._frustum.setFromProjectionMatrix(X_,ee.coordinateSystem,ee.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)i.setRenderTarget(V.map,de),i.clear();else{de===0&&(i.setRenderTarget(V.map),i.clear());let ee=V.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),W.viewport(o)}n=V.getFrustum(de),M(v,E,ue,q,ie,this.type)}V.isPointLightShadow!==!0&&this.type===Xo&&x(V,E),V.needsUpdate=!1}m=this.type,p.needsUpdate=!1,i.setRenderTarget(z,k,N)};function x(T,v){let E=e.update(y);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new yi(s.x,s.y,{format:vr,type:$i}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,i.setRenderTarget(T.mapPass),i.clear(),i.renderBufferDirect(v,null,E,d,y,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,i.setRenderTarget(T.map),i.clear(),i.renderBufferDirect(v,null,E,f,y,null)}function C(T,v,E,z){let k=null,N=E.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(N!==void 0)k=N;else if(k=E.isPointLight===!0?l:a,i.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let W=k.uuid,H=v.uuid,I=c[W];I===void 0&&(I={},c[W]=I);let F=I[H];F===void 0&&(F=k.clone(),I[H]=F,v.addEventListener("dispose",R)),k=F}if(k.visible=v.visible,k.wireframe=v.wireframe,z===Xo?k.side=v.shadowSide!==null?v.shadowSide:v.side:k.side=v.shadowSide!==null?v.shadowSide:u[v.side],k.alphaMap=v.alphaMap,k.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,k.map=v.map,k.clipShadows=v.clipShadows,k.clippingPlanes=v.clippingPlanes,k.clipIntersection=v.clipIntersection,k.displacementMap=v.displacementMap,k.displacementScale=v.displacementScale,k.displacementBias=v.displacementBias,k.wireframeLinewidth=v.wireframeLinewidth,k.linewidth=v.linewidth,E.isPointLight===!0&&k.isMeshDistanceMaterial===!0){let W=i.properties.get(k);W.light=E}return k}function M(T,v,E,z,k,N){if(T.visible===!1)return;if(T.layers.test(k)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&N===Xo)&&(!T.frustumCulled||T.intersectsFrustum(n))){T.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,T.matrixWorld);let I=e.update(T),F=T.material;if(Array.isArray(F)){let q=I.groups;for(let V=0,le=q.length;V<le;V++){let Z=q[V],Q=F[Z.materialIndex];if(Q&&Q.visible){let ie=C(T,Q,z,N);T.onBeforeShadow(i,T,v,E,I,ie,Z),i.renderBufferDirect(E,null,I,ie,T,Z),T.onAfterShadow(i,T,v,E,I,ie,Z)}}}else if(F.visible){let q=C(T,F,z,N);T.onBeforeShadow(i,T,v,E,I,q,null),i.renderBufferDirect(E,null,I,q,T,null),T.onAfterShadow(i,T,v,E,I,q,null)}}let H=T.children;for(let I=0,F=H.length;I<F;I++)M(H[I],v,E,z,k,N)}function R(T){T.target.removeEventListener("dispose",R);for(let E in c){let z=c[E],k=T.target.uuid;k in z&&(z[k].dispose(),delete z[k])}}}function sA(i,e){function t(){let O=!1,re=new Zt,ne=null,Te=new Zt(0,0,0,0);return{setMask:function(ye){ne!==ye&&!O&&(i.colorMask(ye,ye,ye,ye),ne=ye)},setLocked:function(ye){O=ye},setClear:function(ye,Se,We,je,ce){ce===!0&&(ye*=je,Se*=je,We*=je),re.set(ye,Se,We,je),Te.equals(re)===!1&&(i.clearColor(ye,Se,We,je),Te.copy(re))},reset:function(){O=!1,ne=null,Te.set(-1,0,0,0)}}}function n(){let O=!1,re=!1,ne=null,Te=null,ye=null;return{setReversed:function(Se){if(re!==Se){let We=e.get("EXT_clip_control");Se?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let je=ye;ye=null,this.setClear(je)}},getReversed:function(){return re},setTest:function(Se){Se?_e(i.DEPTH_TEST):Ge(i.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!O&&(i.depthMask(Se),ne=Se)},setFunc:function(Se){if(re&&(Se=v_[Se]),Te!==Se){switch(Se){case Uc:i.depthFunc(i.NEVER);break;case Fc:i.depthFunc(i.ALWAYS);break;case Bc:i.depthFunc(i.LESS);break;case Uo:i.depthFunc(i.LEQUAL);break;case zc:i.depthFunc(i.EQUAL);break;case Vc:i.depthFunc(i.GEQUAL);break;case Gc:i.depthFunc(i.GREATER);break;case Hc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Te=Se}},setLocked:function(Se){O=Se},setClear:function(Se){ye!==Se&&(ye=Se,re&&(Se=1-Se),i.clearDepth(Se))},reset:function(){O=!1,ne=null,Te=null,ye=null,re=!1}}}function s(){let O=!1,re=null,ne=null,Te=null,ye=null,Se=null,We=null,je=null,ce=null;return{setTest:function(Be){O||(Be?_e(i.STENCIL_TEST):Ge(i.STENCIL_TEST))},setMask:function(Be){re!==Be&&!O&&(i.stencilMask(Be),re=Be)},setFunc:function(Be,Qe,Ce){(ne!==Be||Te!==Qe||ye!==Ce)&&(i.stencilFunc(Be,Qe,Ce),ne=Be,Te=Qe,ye=Ce)},setOp:function(Be,Qe,Ce){(Se!==Be||We!==Qe||je!==Ce)&&(i.stencilOp(Be,Qe,Ce),Se=Be,We=Qe,je=Ce)},setLocked:function(Be){O=Be},setClear:function(Be){ce!==Be&&(i.clearStencil(Be),ce=Be)},reset:function(){O=!1,re=null,ne=null,Te=null,ye=null,Se=null,We=null,je=null,ce=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,g=[],y=null,p=!1,m=null,x=null,C=null,M=null,R=null,T=null,v=null,E=new ut(0,0,0),z=0,k=!1,N=null,W=null,H=null,I=null,F=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,le=0,Z=i.getParameter(i.VERSION);Z.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(Z)[1]),V=le>=1):Z.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),V=le>=2);let Q=null,ie={},de=i.getParameter(i.SCISSOR_BOX),ue=i.getParameter(i.VIEWPORT),ee=new Zt().fromArray(de),me=new Zt().fromArray(ue);function ge(O,re,ne,Te){let ye=new Uint8Array(4),Se=i.createTexture();i.bindTexture(O,Se),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let We=0;We<ne;We++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(re,0,i.RGBA,1,1,Te,0,i.RGBA,i.UNSIGNED_BYTE,ye):i.texImage2D(re+We,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ye);return Se}let ve={};ve[i.TEXTURE_2D]=ge(i.TEXTURE_2D,i.TEXTURE_2D,1),ve[i.TEXTURE_CUBE_MAP]=ge(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ve[i.TEXTURE_2D_ARRAY]=ge(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ve[i.TEXTURE_3D]=ge(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),_e(i.DEPTH_TEST),o.setFunc(Uo),dn(!1),kt(ep),_e(i.CULL_FACE),Yt(Fr);function _e(O){h[O]!==!0&&(i.enable(O),h[O]=!0)}function Ge(O){h[O]!==!1&&(i.disable(O),h[O]=!1)}function Ze(O,re){return d[O]!==re?(i.bindFramebuffer(O,re),d[O]=re,O===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=re),O===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=re),!0):!1}function Ue(O,re){let ne=g,Te=!1;if(O){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let ye=O.textures;if(ne.length!==ye.length||ne[0]!==i.COLOR_ATTACHMENT0){for(let Se=0,We=ye.length;Se<We;Se++)ne[Se]=i.COLOR_ATTACHMENT0+Se;ne.length=ye.length,Te=!0}}else ne[0]!==i.BACK&&(ne[0]=i.BACK,Te=!0);Te&&i.drawBuffers(ne)}function st(O){return y!==O?(i.useProgram(O),y=O,!0):!1}let ct={[Br]:i.FUNC_ADD,[z0]:i.FUNC_SUBTRACT,[V0]:i.FUNC_REVERSE_SUBTRACT};ct[G0]=i.MIN,ct[H0]=i.MAX;let rt={[W0]:i.ZERO,[X0]:i.ONE,[q0]:i.SRC_COLOR,[sp]:i.SRC_ALPHA,[j0]:i.SRC_ALPHA_SATURATE,[Z0]:i.DST_COLOR,[Y0]:i.DST_ALPHA,[$0]:i.ONE_MINUS_SRC_COLOR,[rp]:i.ONE_MINUS_SRC_ALPHA,[J0]:i.ONE_MINUS_DST_COLOR,[K0]:i.ONE_MINUS_DST_ALPHA,[Q0]:i.CONSTANT_COLOR,[e_]:i.ONE_MINUS_CONSTANT_COLOR,[t_]:i.CONSTANT_ALPHA,[n_]:i.ONE_MINUS_CONSTANT_ALPHA};function Yt(O,re,ne,Te,ye,Se,We,je,ce,Be){if(O===Fr){p===!0&&(Ge(i.BLEND),p=!1);return}if(p===!1&&(_e(i.BLEND),p=!0),O!==B0){if(O!==m||Be!==k){if((x!==Br||R!==Br)&&(i.blendEquation(i.FUNC_ADD),x=Br,R=Br),Be)switch(O){case qo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case tp:i.blendFunc(i.ONE,i.ONE);break;case np:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ip:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:nt("WebGLState: Invalid blending: ",O);break}else switch(O){case qo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case tp:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case np:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ip:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",O);break}C=null,M=null,T=null,v=null,E.set(0,0,0),z=0,m=O,k=Be}return}ye=ye||re,Se=Se||ne,We=We||Te,(re!==x||ye!==R)&&(i.blendEquationSeparate(ct[re],ct[ye]),x=re,R=ye),(ne!==C||Te!==M||Se!==T||We!==v)&&(i.blendFuncSeparate(rt[ne],rt[Te],rt[Se],rt[We]),C=ne,M=Te,T=Se,v=We),(je.equals(E)===!1||ce!==z)&&(i.blendColor(je.r,je.g,je.b,ce),E.copy(je),z=ce),m=O,k=!1}function zt(O,re){O.side===ai?Ge(i.CULL_FACE):_e(i.CULL_FACE);let ne=O.side===ii;re&&(ne=!ne),dn(ne),O.blending===qo&&O.transparent===!1?Yt(Fr):Yt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Te=O.stencilWrite;a.setTest(Te),Te&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),wt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?_e(i.SAMPLE_ALPHA_TO_COVERAGE):Ge(i.SAMPLE_ALPHA_TO_COVERAGE)}function dn(O){N!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),N=O)}function kt(O){O!==O0?(_e(i.CULL_FACE),O!==W&&(O===ep?i.cullFace(i.BACK):O===U0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ge(i.CULL_FACE),W=O}function Rn(O){O!==H&&(V&&i.lineWidth(O),H=O)}function wt(O,re,ne){O?(_e(i.POLYGON_OFFSET_FILL),(I!==re||F!==ne)&&(I=re,F=ne,o.getReversed()&&(re=-re,ne=-ne),i.polygonOffset(re,ne))):Ge(i.POLYGON_OFFSET_FILL)}function Sn(O){O?_e(i.SCISSOR_TEST):Ge(i.SCISSOR_TEST)}function nn(O){O===void 0&&(O=i.TEXTURE0+q-1),Q!==O&&(i.activeTexture(O),Q=O)}function fn(O,re,ne){ne===void 0&&(Q===null?ne=i.TEXTURE0+q-1:ne=Q);let Te=ie[ne];Te===void 0&&(Te={type:void 0,texture:void 0},ie[ne]=Te),(Te.type!==O||Te.texture!==re)&&(Q!==ne&&(i.activeTexture(ne),Q=ne),i.bindTexture(O,re||ve[O]),Te.type=O,Te.texture=re)}function U(){let O=ie[Q];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Pe(){try{i.compressedTexImage2D(...arguments)}catch(O){nt("WebGLState:",O)}}function Ye(){try{i.compressedTexImage3D(...arguments)}catch(O){nt("WebGLState:",O)}}function lt(){try{i.texSubImage2D(...arguments)}catch(O){nt("WebGLState:",O)}}function Me(){try{i.texSubImage3D(...arguments)}catch(O){nt("WebGLState:",O)}}function Ut(){try{i.compressedTexSubImage2D(...arguments)}catch(O){nt("WebGLState:",O)}}function He(){try{i.compressedTexSubImage3D(...arguments)}catch(O){nt("WebGLState:",O)}}function qe(){try{i.texStorage2D(...arguments)}catch(O){nt("WebGLState:",O)}}function P(){try{i.texStorage3D(...arguments)}catch(O){nt("WebGLState:",O)}}function b(){try{i.texImage2D(...arguments)}catch(O){nt("WebGLState:",O)}}function X(){try{i.texImage3D(...arguments)}catch(O){nt("WebGLState:",O)}}function he(O){return u[O]!==void 0?u[O]:i.getParameter(O)}function oe(O,re){u[O]!==re&&(i.pixelStorei(O,re),u[O]=re)}function xe(O){ee.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function be(O){me.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function te(O,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Te=ne.get(O);Te===void 0&&(Te=i.getUniformBlockIndex(re,O.name),i.uniformBlockBinding(re,Te,Te),ne.set(O,Te))}function se(O,re,ne){let ye=c.get(re).get(O);l[ye]!==ne&&(i.bindBufferBase(i.UNIFORM_BUFFER,ye,ne),l[ye]=ne)}function pe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,ie={},d={},l={},f=new WeakMap,g=[],y=null,p=!1,m=null,x=null,C=null,M=null,R=null,T=null,v=null,E=new ut(0,0,0),z=0,k=!1,N=null,W=null,H=null,I=null,F=null,ee.set(0,0,i.canvas.width,i.canvas.height),me.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:_e,disable:Ge,bindFramebuffer:Ze,drawBuffers:Ue,useProgram:st,setBlending:Yt,setMaterial:zt,setFlipSided:dn,setCullFace:kt,setLineWidth:Rn,setPolygonOffset:wt,setScissorTest:Sn,activeTexture:nn,bindTexture:fn,unbindTexture:U,compressedTexImage2D:Pe,compressedTexImage3D:Ye,texImage2D:b,texImage3D:X,pixelStorei:oe,getParameter:he,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:qe,texStorage3D:P,texSubImage2D:lt,texSubImage3D:Me,compressedTexSubImage2D:Ut,compressedTexSubImage3D:He,scissor:xe,viewport:be,reset:pe}}function rA(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new et,h=new WeakMap,u=new Set,d,f=new WeakMap,g=new Set,y=new FinalizationRegistry(P=>g.delete(P)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(P,b){return p?new OffscreenCanvas(P,b):qa("canvas")}function x(P,b,X){let he=1,oe=qe(P);if((oe.width>X||oe.height>X)&&(he=X/Math.max(oe.width,oe.height)),he<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let xe=Math.floor(he*oe.width),be=Math.floor(he*oe.height);d===void 0&&(d=m(xe,be));let te=b?m(xe,be):d;return te.width=xe,te.height=be,te.getContext("2d").drawImage(P,0,0,xe,be),$e("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+xe+"x"+be+")."),te}else return"data"in P&&$e("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),P;return P}function C(P){return P.generateMipmaps}function M(P){i.generateMipmap(P)}function R(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(P,b,X,he,oe,xe=!1){if(P!==null){if(i[P]!==void 0)return i[P];$e("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let be;he&&(be=e.get("EXT_texture_norm16"),be||$e("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=b;if(b===i.RED&&(X===i.FLOAT&&(te=i.R32F),X===i.HALF_FLOAT&&(te=i.R16F),X===i.UNSIGNED_BYTE&&(te=i.R8),X===i.UNSIGNED_SHORT&&be&&(te=be.R16_EXT),X===i.SHORT&&be&&(te=be.R16_SNORM_EXT)),b===i.RED_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.R8UI),X===i.UNSIGNED_SHORT&&(te=i.R16UI),X===i.UNSIGNED_INT&&(te=i.R32UI),X===i.BYTE&&(te=i.R8I),X===i.SHORT&&(te=i.R16I),X===i.INT&&(te=i.R32I)),b===i.RG&&(X===i.FLOAT&&(te=i.RG32F),X===i.HALF_FLOAT&&(te=i.RG16F),X===i.UNSIGNED_BYTE&&(te=i.RG8),X===i.UNSIGNED_SHORT&&be&&(te=be.RG16_EXT),X===i.SHORT&&be&&(te=be.RG16_SNORM_EXT)),b===i.RG_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RG8UI),X===i.UNSIGNED_SHORT&&(te=i.RG16UI),X===i.UNSIGNED_INT&&(te=i.RG32UI),X===i.BYTE&&(te=i.RG8I),X===i.SHORT&&(te=i.RG16I),X===i.INT&&(te=i.RG32I)),b===i.RGB_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RGB8UI),X===i.UNSIGNED_SHORT&&(te=i.RGB16UI),X===i.UNSIGNED_INT&&(te=i.RGB32UI),X===i.BYTE&&(te=i.RGB8I),X===i.SHORT&&(te=i.RGB16I),X===i.INT&&(te=i.RGB32I)),b===i.RGBA_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),X===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),X===i.UNSIGNED_INT&&(te=i.RGBA32UI),X===i.BYTE&&(te=i.RGBA8I),X===i.SHORT&&(te=i.RGBA16I),X===i.INT&&(te=i.RGBA32I)),b===i.RGB&&(X===i.UNSIGNED_SHORT&&be&&(te=be.RGB16_EXT),X===i.SHORT&&be&&(te=be.RGB16_SNORM_EXT),X===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),X===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),b===i.RGBA){let se=xe?Xa:xt.getTransfer(oe);X===i.FLOAT&&(te=i.RGBA32F),X===i.HALF_FLOAT&&(te=i.RGBA16F),X===i.UNSIGNED_BYTE&&(te=se===Pt?i.SRGB8_ALPHA8:i.RGBA8),X===i.UNSIGNED_SHORT&&be&&(te=be.RGBA16_EXT),X===i.SHORT&&be&&(te=be.RGBA16_SNORM_EXT),X===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),X===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(P,b){let X;return P?b===null||b===qi||b===Vr?X=i.DEPTH24_STENCIL8:b===Ri?X=i.DEPTH32F_STENCIL8:b===Yo&&(X=i.DEPTH24_STENCIL8,$e("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===qi||b===Vr?X=i.DEPTH_COMPONENT24:b===Ri?X=i.DEPTH_COMPONENT32F:b===Yo&&(X=i.DEPTH_COMPONENT16),X}function E(P,b){return C(P)===!0||P.isFramebufferTexture&&P.minFilter!==yn&&P.minFilter!==ti?Math.log2(Math.max(b.width,b.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?b.mipmaps.length:1}function z(P){let b=new WeakRef(P);n.get(P).__ref=b,g.add(b),y.register(P,b,b)}function k(P){let b=n.get(P).__ref;b!==void 0&&(g.delete(b),y.unregister(b))}function N(P){H(P.target)}function W(P){I(P.target)}function H(P){P.removeEventListener("dispose",N),k(P),q(P),P.isVideoTexture&&h.delete(P),P.isHTMLTexture&&u.delete(P)}function I(P){P.removeEventListener("dispose",W),k(P),le(P)}function F(){for(let P of g){let b=P.deref();b!==void 0&&(b.isRenderTarget===!0?I(b):H(b))}g.clear(),u.clear()}function q(P){let b=n.get(P);if(b.__webglInit===void 0)return;let X=P.source,he=f.get(X);if(he){let oe=he[b.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&V(P),Object.keys(he).length===0&&f.delete(X)}n.remove(P)}function V(P){let b=n.get(P);i.deleteTexture(b.__webglTexture);let X=P.source,he=f.get(X);delete he[b.__cacheKey],o.memory.textures--}function le(P){let b=n.get(P);b.__depthDisposeCallback&&b.__depthDisposeCallback();let X=P.depthTexture;if(X&&X.renderTarget===P&&H(X),P.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(b.__webglFramebuffer[oe]))for(let xe=0;xe<b.__webglFramebuffer[oe].length;xe++)i.deleteFramebuffer(b.__webglFramebuffer[oe][xe]);else i.deleteFramebuffer(b.__webglFramebuffer[oe]);b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer[oe])}else{if(Array.isArray(b.__webglFramebuffer))for(let oe=0;oe<b.__webglFramebuffer.length;oe++)i.deleteFramebuffer(b.__webglFramebuffer[oe]);else i.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&i.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let oe=0;oe<b.__webglColorRenderbuffer.length;oe++)b.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(b.__webglColorRenderbuffer[oe]);b.__webglDepthRenderbuffer&&i.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let he=P.textures;for(let oe=0,xe=he.length;oe<xe;oe++){let be=n.get(he[oe]);be.__webglTexture&&(i.deleteTexture(be.__webglTexture),o.memory.textures--),n.remove(he[oe])}n.remove(P)}let Z=0;function Q(){Z=0}function ie(){return Z}function de(P){Z=P}function ue(){let P=Z;return P>=s.maxTextures&&$e("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,P}function ee(P){let b=[];return b.push(P.wrapS),b.push(P.wrapT),b.push(P.wrapR||0),b.push(P.magFilter),b.push(P.minFilter),b.push(P.anisotropy),b.push(P.internalFormat),b.push(P.format),b.push(P.type),b.push(P.generateMipmaps),b.push(P.mipmapsAutoUpdate),b.push(P.premultiplyAlpha),b.push(P.flipY),b.push(P.unpackAlignment),b.push(P.colorSpace),b.join()}function me(P,b){let X=n.get(P);if(P.isVideoTexture&&Ut(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&X.__version!==P.version){let he=P.image;if(he===null)$e("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)$e("WebGLRenderer: Texture marked for update but image is incomplete");else{zt(X,P,b);return}}else P.isExternalTexture&&(X.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,X.__webglTexture,i.TEXTURE0+b)}function ge(P,b){let X=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&X.__version!==P.version){zt(X,P,b);return}else P.isExternalTexture&&(X.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,X.__webglTexture,i.TEXTURE0+b)}function ve(P,b){let X=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&X.__version!==P.version){zt(X,P,b);return}t.bindTexture(i.TEXTURE_3D,X.__webglTexture,i.TEXTURE0+b)}function _e(P,b){let X=n.get(P);if(P.version>0&&X.__version!==P.version){dn(X,P,b);return}t.bindTexture(i.TEXTURE_CUBE_MAP,X.__webglTexture,i.TEXTURE0+b)}let Ge={[Wc]:i.REPEAT,[ds]:i.CLAMP_TO_EDGE,[Xc]:i.MIRRORED_REPEAT},Ze={[yn]:i.NEAREST,[r_]:i.NEAREST_MIPMAP_NEAREST,[pl]:i.NEAREST_MIPMAP_LINEAR,[ti]:i.LINEAR,[vh]:i.LINEAR_MIPMAP_NEAREST,[Xs]:i.LINEAR_MIPMAP_LINEAR},Ue={[c_]:i.NEVER,[wp]:i.ALWAYS,[h_]:i.LESS,[xp]:i.LEQUAL,[u_]:i.EQUAL,[bp]:i.GEQUAL,[d_]:i.GREATER,[f_]:i.NOTEQUAL};function st(P,b){if(b.type===Ri&&e.has("OES_texture_float_linear")===!1&&(b.magFilter===ti||b.magFilter===vh||b.magFilter===pl||b.magFilter===Xs||b.minFilter===ti||b.minFilter===vh||b.minFilter===pl||b.minFilter===Xs)&&$e("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,Ge[b.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,Ge[b.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,Ge[b.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,Ze[b.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,Ze[b.minFilter]),b.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,Ue[b.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===yn||b.minFilter!==pl&&b.minFilter!==Xs||b.type===Ri&&e.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||n.get(b).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");i.texParameterf(P,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),n.get(b).__currentAnisotropy=b.anisotropy}}}function ct(P,b){let X=!1;P.__webglInit===void 0&&(P.__webglInit=!0,b.addEventListener("dispose",N),z(b));let he=b.source,oe=f.get(he);oe===void 0&&(oe={},f.set(he,oe));let xe=ee(b);if(xe!==P.__cacheKey){oe[xe]===void 0&&(oe[xe]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,X=!0),oe[xe].usedTimes++;let be=oe[P.__cacheKey];be!==void 0&&(oe[P.__cacheKey].usedTimes--,be.usedTimes===0&&V(b)),P.__cacheKey=xe,P.__webglTexture=oe[xe].texture}return X}function rt(P,b,X){return Math.floor(Math.floor(P/X)/b)}function Yt(P,b,X,he){let xe=P.updateRanges;if(xe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,b.width,b.height,X,he,b.data);else{xe.sort((O,re)=>O.start-re.start);let be=0;for(let O=1;O<xe.length;O++){let re=xe[be],ne=xe[O],Te=re.start+re.count,ye=rt(ne.start,b.width,4),Se=rt(re.start,b.width,4);ne.start<=Te+1&&ye===Se&&rt(ne.start+ne.count-1,b.width,4)===ye?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++be,xe[be]=ne)}xe.length=be+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),pe=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,b.width);for(let O=0,re=xe.length;O<re;O++){let ne=xe[O],Te=Math.floor(ne.start/4),ye=Math.ceil(ne.count/4),Se=Te%b.width,We=Math.floor(Te/b.width),je=ye,ce=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(i.UNPACK_SKIP_ROWS,We),t.texSubImage2D(i.TEXTURE_2D,0,Se,We,je,ce,X,he,b.data)}P.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,pe)}}function zt(P,b,X){let he=i.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(he=i.TEXTURE_2D_ARRAY),b.isData3DTexture&&(he=i.TEXTURE_3D);let oe=ct(P,b),xe=b.source;t.bindTexture(he,P.__webglTexture,i.TEXTURE0+X);let be=n.get(xe);if(xe.version!==be.__version||oe===!0){if(t.activeTexture(i.TEXTURE0+X),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let ce=xt.getPrimaries(xt.workingColorSpace),Be=b.colorSpace===$s?null:xt.getPrimaries(b.colorSpace),Qe=b.colorSpace===$s||ce===Be?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qe)}t.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment);let se=x(b.image,!1,s.maxTextureSize);se=He(b,se);let pe=r.convert(b.format,b.colorSpace),O=r.convert(b.type),re=T(b.internalFormat,pe,O,b.normalized,b.colorSpace,b.isVideoTexture);st(he,b);let ne,Te=b.mipmaps,ye=b.isVideoTexture!==!0,Se=be.__version===void 0||oe===!0,We=xe.dataReady,je=E(b,se);if(b.isDepthTexture)re=v(b.format===qs,b.type),Se&&(ye?t.texStorage2D(i.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,pe,O,null));else if(b.isDataTexture)if(Te.length>0){ye&&Se&&t.texStorage2D(i.TEXTURE_2D,je,re,Te[0].width,Te[0].height);for(let ce=0,Be=Te.length;ce<Be;ce++)ne=Te[ce],ye?We&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(i.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,O,ne.data);b.generateMipmaps=!1}else ye?(Se&&t.texStorage2D(i.TEXTURE_2D,je,re,se.width,se.height),We&&Yt(b,se,pe,O)):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,pe,O,se.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){ye&&Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,je,re,Te[0].width,Te[0].height,se.depth);for(let ce=0,Be=Te.length;ce<Be;ce++)if(ne=Te[ce],b.format!==Yi)if(pe!==null)if(ye){if(We)if(b.layerUpdates.size>0){let Qe=Ip(ne.width,ne.height,b.format,b.type);for(let Ce of b.layerUpdates){let ht=ne.data.subarray(Ce*Qe/ne.data.BYTES_PER_ELEMENT,(Ce+1)*Qe/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,pe,ht)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else $e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?We&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,O,ne.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,pe,O,ne.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{ye&&Se&&t.texStorage2D(i.TEXTURE_2D,je,re,Te[0].width,Te[0].height);for(let ce=0,Be=Te.length;ce<Be;ce++)ne=Te[ce],b.format!==Yi?pe!==null?ye?We&&t.compressedTexSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(i.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?We&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(i.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,O,ne.data)}else if(b.isDataArrayTexture)if(ye){if(Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,je,re,se.width,se.height,se.depth),We)if(b.layerUpdates.size>0){let ce=Ip(se.width,se.height,b.format,b.type);for(let Be of b.layerUpdates){let Qe=se.data.subarray(Be*ce/se.data.BYTES_PER_ELEMENT,(Be+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Be,se.width,se.height,1,pe,O,Qe)}b.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,O,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,O,se.data);else if(b.isData3DTexture)ye?(Se&&t.texStorage3D(i.TEXTURE_3D,je,re,se.width,se.height,se.depth),We&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,O,se.data)):t.texImage3D(i.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,O,se.data);else if(b.isFramebufferTexture){if(Se)if(ye)t.texStorage2D(i.TEXTURE_2D,je,re,se.width,se.height);else{let ce=se.width,Be=se.height;for(let Qe=0;Qe<je;Qe++)t.texImage2D(i.TEXTURE_2D,Qe,re,ce,Be,0,pe,O,null),ce>>=1,Be>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in i){let ce=i.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),u.add(b),ce.onpaint=Be=>{let Qe=Be.changedElements;for(let Ce of u)Qe.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let Qe=i.RGBA,Ce=i.RGBA,ht=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Qe,Ce,ht,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Te.length>0){if(ye&&Se){let ce=qe(Te[0]);t.texStorage2D(i.TEXTURE_2D,je,re,ce.width,ce.height)}for(let ce=0,Be=Te.length;ce<Be;ce++)ne=Te[ce],ye?We&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,pe,O,ne):t.texImage2D(i.TEXTURE_2D,ce,re,pe,O,ne);b.generateMipmaps=!1}else if(ye){if(Se){let ce=qe(se);t.texStorage2D(i.TEXTURE_2D,je,re,ce.width,ce.height)}We&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe,O,se)}else t.texImage2D(i.TEXTURE_2D,0,re,pe,O,se);C(b)&&b.mipmapsAutoUpdate===!0&&M(he),be.__version=xe.version,b.onUpdate&&b.onUpdate(b)}P.__version=b.version}function dn(P,b,X){if(b.image.length!==6)return;let he=ct(P,b),oe=b.source;t.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+X);let xe=n.get(oe);if(oe.version!==xe.__version||he===!0){t.activeTexture(i.TEXTURE0+X);let be=xt.getPrimaries(xt.workingColorSpace),te=b.colorSpace===$s?null:xt.getPrimaries(b.colorSpace),se=b.colorSpace===$s||be===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=b.isCompressedTexture||b.image[0].isCompressedTexture,O=b.image[0]&&b.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!O?re[Ce]=x(b.image[Ce],!0,s.maxCubemapSize):re[Ce]=O?b.image[Ce].image:b.image[Ce],re[Ce]=He(b,re[Ce]);let ne=re[0],Te=r.convert(b.format,b.colorSpace),ye=r.convert(b.type),Se=T(b.internalFormat,Te,ye,b.normalized,b.colorSpace),We=b.isVideoTexture!==!0,je=xe.__version===void 0||he===!0,ce=oe.dataReady,Be=E(b,ne);st(i.TEXTURE_CUBE_MAP,b);let Qe;if(b.isDepthTexture){if(Se=v(b.format===qs,b.type),je)if(We)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,ne.width,ne.height,0,Te,ye,null)}else if(pe){We&&je&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,Se,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){Qe=re[Ce].mipmaps;for(let ht=0;ht<Qe.length;ht++){let Vt=Qe[ht];b.format!==Yi?Te!==null?We?ce&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,0,0,Vt.width,Vt.height,Te,Vt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,Se,Vt.width,Vt.height,0,Vt.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,0,0,Vt.width,Vt.height,Te,ye,Vt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,Se,Vt.width,Vt.height,0,Te,ye,Vt.data)}}}else{if(Qe=b.mipmaps,We&&je){Qe.length>0&&Be++;let Ce=qe(re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,Se,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(O){We?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,Te,ye,re[Ce].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,re[Ce].width,re[Ce].height,0,Te,ye,re[Ce].data);for(let ht=0;ht<Qe.length;ht++){let Yn=Qe[ht].image[Ce].image;We?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,0,0,Yn.width,Yn.height,Te,ye,Yn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,Se,Yn.width,Yn.height,0,Te,ye,Yn.data)}}else{We?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Te,ye,re[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,Te,ye,re[Ce]);for(let ht=0;ht<Qe.length;ht++){let Vt=Qe[ht];We?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,0,0,Te,ye,Vt.image[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,Se,Te,ye,Vt.image[Ce])}}}C(b)&&b.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),xe.__version=oe.version,b.onUpdate&&b.onUpdate(b)}P.__version=b.version}function kt(P,b,X,he,oe,xe){let be=r.convert(X.format,X.colorSpace),te=r.convert(X.type),se=T(X.internalFormat,be,te,X.normalized,X.colorSpace),pe=n.get(b),O=n.get(X);if(O.__renderTarget=b,!pe.__hasExternalTextures){let re=Math.max(1,b.width>>xe),ne=Math.max(1,b.height>>xe);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,xe,se,re,ne,b.depth,0,be,te,null):t.texImage2D(oe,xe,se,re,ne,0,be,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,P),Me(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,he,oe,O.__webglTexture,0,lt(b)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,he,oe,O.__webglTexture,xe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Rn(P,b,X){if(i.bindRenderbuffer(i.RENDERBUFFER,P),b.depthBuffer){let he=b.depthTexture,oe=he&&he.isDepthTexture?he.type:null,xe=v(b.stencilBuffer,oe),be=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Me(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(b),xe,b.width,b.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(b),xe,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,xe,b.width,b.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,be,i.RENDERBUFFER,P)}else{let he=b.textures;for(let oe=0;oe<he.length;oe++){let xe=he[oe],be=r.convert(xe.format,xe.colorSpace),te=r.convert(xe.type),se=T(xe.internalFormat,be,te,xe.normalized,xe.colorSpace);Me(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(b),se,b.width,b.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(b),se,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,se,b.width,b.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function wt(P,b,X){let he=b.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,P),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(b.depthTexture);oe.__renderTarget=b;let xe=he?b.depthTexture.image[0]:b.depthTexture.image;(!oe.__webglTexture||xe.width!==b.width||xe.height!==b.height)&&(xe.width=b.width,xe.height=b.height,b.depthTexture.needsUpdate=!0),he?_e(b.depthTexture,0):me(b.depthTexture,0);let be=oe.__webglTexture,te=lt(b),se=he?i.TEXTURE_CUBE_MAP_POSITIVE_X+X:i.TEXTURE_2D,pe=b.depthTexture.format===qs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(b.depthTexture.format===zs)Me(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,se,be,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,pe,se,be,0);else if(b.depthTexture.format===qs)Me(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,se,be,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,pe,se,be,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Sn(P){let b=n.get(P),X=P.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==P.depthTexture){let he=P.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),he){let oe=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,he.removeEventListener("dispose",oe)};he.addEventListener("dispose",oe),b.__depthDisposeCallback=oe}b.__boundDepthTexture=he}if(P.depthTexture&&!b.__autoAllocateDepthBuffer)if(X)for(let he=0;he<6;he++)wt(b.__webglFramebuffer[he],P,he);else P.texture.mipmaps.length>0?wt(b.__webglFramebuffer[0],P,0):wt(b.__webglFramebuffer,P,0);else if(X){b.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[he]),b.__webglDepthbuffer[he]===void 0)b.__webglDepthbuffer[he]=i.createRenderbuffer(),Rn(b.__webglDepthbuffer[he],P,!1);else{let oe=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=b.__webglDepthbuffer[he];i.bindRenderbuffer(i.RENDERBUFFER,xe),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,xe)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=i.createRenderbuffer(),Rn(b.__webglDepthbuffer,P,!1);else{let oe=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=b.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,xe),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,xe)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function nn(P,b,X){let he=n.get(P);b!==void 0&&kt(he.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),X!==void 0&&Sn(P)}function fn(P){let b=P.texture,X=n.get(P),he=n.get(b);P.addEventListener("dispose",W),z(P);let oe=P.textures,xe=P.isWebGLCubeRenderTarget===!0,be=oe.length>1;if(be||(he.__webglTexture===void 0&&(he.__webglTexture=i.createTexture()),he.__version=b.version,o.memory.textures++),xe){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(b.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let se=0;se<b.mipmaps.length;se++)X.__webglFramebuffer[te][se]=i.createFramebuffer()}else X.__webglFramebuffer[te]=i.createFramebuffer()}else{if(b.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<b.mipmaps.length;te++)X.__webglFramebuffer[te]=i.createFramebuffer()}else X.__webglFramebuffer=i.createFramebuffer();if(be)for(let te=0,se=oe.length;te<se;te++){let pe=n.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&Me(P)===!1){X.__webglMultisampledFramebuffer=i.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];X.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),O=r.convert(se.type),re=T(se.internalFormat,pe,O,se.normalized,se.colorSpace,P.isXRRenderTarget===!0),ne=lt(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,ne,re,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,X.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&(X.__webglDepthRenderbuffer=i.createRenderbuffer(),Rn(X.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(xe){t.bindTexture(i.TEXTURE_CUBE_MAP,he.__webglTexture),st(i.TEXTURE_CUBE_MAP,b);for(let te=0;te<6;te++)if(b.mipmaps.length>0)for(let se=0;se<b.mipmaps.length;se++)kt(X.__webglFramebuffer[te][se],P,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else kt(X.__webglFramebuffer[te],P,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);C(b)?M(i.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}else if(be){for(let te=0,se=oe.length;te<se;te++){let pe=oe[te],O=n.get(pe),re=i.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(re=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(re,O.__webglTexture),st(re,pe),kt(X.__webglFramebuffer,P,pe,i.COLOR_ATTACHMENT0+te,re,0),C(pe)&&M(re)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(te=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,he.__webglTexture),st(te,b),b.mipmaps.length>0)for(let se=0;se<b.mipmaps.length;se++)kt(X.__webglFramebuffer[se],P,b,i.COLOR_ATTACHMENT0,te,se);else kt(X.__webglFramebuffer,P,b,i.COLOR_ATTACHMENT0,te,0);C(b)?M(te):b.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&Sn(P)}function U(P){let b=P.textures;for(let X=0,he=b.length;X<he;X++){let oe=b[X];if(C(oe)&&oe.mipmapsAutoUpdate===!0){let xe=R(P),be=n.get(oe).__webglTexture;t.bindTexture(xe,be),M(xe),t.unbindTexture()}}}let Pe=[];function Ye(P){if(P.samples>0){if(Me(P)===!1){let b=P.textures,X=P.width,he=P.height,oe=i.COLOR_BUFFER_BIT,xe=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=n.get(P),te=b.length>1;if(te)for(let pe=0;pe<b.length;pe++)t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let pe=0;pe<b.length;pe++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,be.__webglColorRenderbuffer[pe]);let O=n.get(b[pe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,O,0)}i.blitFramebuffer(0,0,X,he,0,0,X,he,oe,i.NEAREST),l===!0&&(Pe.length=0,Pe.push(i.COLOR_ATTACHMENT0+pe),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Pe.push(xe),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<b.length;pe++){t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,be.__webglColorRenderbuffer[pe]);let O=n.get(b[pe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,O,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let b=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[b])}}}function lt(P){return Math.min(s.maxSamples,P.samples)}function Me(P){let b=n.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Ut(P){let b=o.render.frame;h.get(P)!==b&&(h.set(P,b),P.update())}function He(P,b){let X=P.colorSpace,he=P.format,oe=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||X!==Wa&&X!==$s&&(xt.getTransfer(X)===Pt?(he!==Yi||oe!==li)&&$e("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",X)),b}function qe(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=ve,this.setTextureCube=_e,this.rebindTextures=nn,this.setupRenderTarget=fn,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=Ye,this.setupDepthRenderbuffer=Sn,this.setupFrameBufferTexture=kt,this.useMultisampledRTT=Me,this.dispose=F}function oA(i,e){function t(n,s=$s){let r,o=xt.getTransfer(s);if(n===li)return i.UNSIGNED_BYTE;if(n===xh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===bh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===gp)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===_p)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===pp)return i.BYTE;if(n===mp)return i.SHORT;if(n===Yo)return i.UNSIGNED_SHORT;if(n===yh)return i.INT;if(n===qi)return i.UNSIGNED_INT;if(n===Ri)return i.FLOAT;if(n===$i)return i.HALF_FLOAT;if(n===vp)return i.ALPHA;if(n===yp)return i.RGB;if(n===Yi)return i.RGBA;if(n===zs)return i.DEPTH_COMPONENT;if(n===qs)return i.DEPTH_STENCIL;if(n===wh)return i.RED;if(n===Sh)return i.RED_INTEGER;if(n===vr)return i.RG;if(n===Mh)return i.RG_INTEGER;if(n===Th)return i.RGBA_INTEGER;if(n===ml||n===gl||n===_l||n===vl)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ml)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===gl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===_l)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===vl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ml)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===gl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===_l)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===vl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Eh||n===Ah||n===Ch||n===Ph)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Eh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Ah)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Ch)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Ph)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Rh||n===Lh||n===Ih||n===Dh||n===Nh||n===yl||n===kh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Rh||n===Lh)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Ih)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Dh)return r.COMPRESSED_R11_EAC;if(n===Nh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===yl)return r.COMPRESSED_RG11_EAC;if(n===kh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Oh||n===Uh||n===Fh||n===Bh||n===zh||n===Vh||n===Gh||n===Hh||n===Wh||n===Xh||n===qh||n===$h||n===Yh||n===Kh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Oh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Uh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Fh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Bh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===zh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Vh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Gh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Hh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Wh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Xh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===qh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===$h)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Yh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Kh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Zh||n===Jh||n===jh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Zh)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Jh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===jh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Qh||n===eu||n===xl||n===tu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Qh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===eu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===xl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===tu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Vr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var aA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,lA=`
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

}`,qp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new rl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ms({vertexShader:aA,fragmentShader:lA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new en(new ps(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},$p=class extends Hi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,g=null,y=typeof XRWebGLBinding<"u",p=new qp,m={},x=t.getContextAttributes(),C=null,M=null,R=[],T=[],v=new et,E=null,z=null,k=new ei;k.viewport=new Zt;let N=new ei;N.viewport=new Zt;let W=[k,N],H=new fh,I=null,F=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=R[ee];return me===void 0&&(me=new Go,R[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=R[ee];return me===void 0&&(me=new Go,R[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=R[ee];return me===void 0&&(me=new Go,R[ee]=me),me.getHandSpace()};function q(ee){let me=T.indexOf(ee.inputSource);if(me===-1)return;let ge=R[me];ge!==void 0&&(ge.update(ee.inputSource,ee.frame,c||o),ge.dispatchEvent({type:ee.type,data:ee.inputSource}))}function V(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<R.length;ee++){let me=T[ee];me!==null&&(T[ee]=null,R[ee].disconnect(me))}I=null,F=null,p.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(C),f=null,d=null,u=null,s=null,M=null,ue.stop(),n.isPresenting=!1,e.setPixelRatio(E),e.setSize(v.width,v.height,!1),z!==null){let ee=z.camera;ee.fov=z.fov,ee.zoom=z.zoom,ee.updateProjectionMatrix(),z=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&$e("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&$e("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",V),s.addEventListener("inputsourceschange",le),x.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(v),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,ve=null,_e=null;x.depth&&(_e=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=x.stencil?qs:zs,ve=x.stencil?Vr:qi);let Ge={colorFormat:t.RGBA8,depthFormat:_e,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ge),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),M=new yi(d.textureWidth,d.textureHeight,{format:Yi,type:li,depthTexture:new Ws(d.textureWidth,d.textureHeight,ve,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ge={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new yi(f.framebufferWidth,f.framebufferHeight,{format:Yi,type:li,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ge=ee.removed[me],ve=T.indexOf(ge);ve>=0&&(T[ve]=null,R[ve].disconnect(ge))}for(let me=0;me<ee.added.length;me++){let ge=ee.added[me],ve=T.indexOf(ge);if(ve===-1){for(let Ge=0;Ge<R.length;Ge++)if(Ge>=T.length){T.push(ge),ve=Ge;break}else if(T[Ge]===null){T[Ge]=ge,ve=Ge;break}if(ve===-1)break}let _e=R[ve];_e&&_e.connect(ge)}}function Z(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ge=ee.far;p.texture!==null&&(p.depthNear>0&&(me=p.depthNear),p.depthFar>0&&(ge=p.depthFar)),H.near=N.near=k.near=me,H.far=N.far=k.far=ge,(I!==H.near||F!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),I=H.near,F=H.far),H.layers.mask=ee.layers.mask|6,k.layers.mask=H.layers.mask&-5,N.layers.mask=H.layers.mask&-3;let ve=ee.parent,_e=H.cameras;Z(H,ve);for(let Ge=0;Ge<_e.length;Ge++)Z(_e[Ge],ve);H.projectionMatrix.copy(k.projectionMatrix),H.projectionMatrixInverse.copy(k.projectionMatrixInverse),z===null&&ee.isPerspectiveCamera&&(z={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,H,ve)};function Q(ee,me,ge){ge===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ge.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=zo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(H)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function de(ee,me){if(h=me.getViewerPose(c||o),g=me,h!==null){let ge=h.views;f!==null&&(e.setRenderTargetFramebuffer(M,f.framebuffer),e.setRenderTarget(M));let ve=!1;ge.length!==H.cameras.length&&(H.cameras.length=0,ve=!0);for(let Ue=0;Ue<ge.length;Ue++){let st=ge[Ue],ct=null;if(f!==null)ct=f.getViewport(st);else{let Yt=u.getViewSubImage(d,st);ct=Yt.viewport,Ue===0&&(e.setRenderTargetTextures(M,Yt.colorTexture,Yt.depthStencilTexture),e.setRenderTarget(M))}let rt=W[Ue];rt===void 0&&(rt=new ei,rt.layers.enable(Ue),rt.viewport=new Zt,W[Ue]=rt),rt.matrix.fromArray(st.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(st.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ct.x,ct.y,ct.width,ct.height),Ue===0&&(H.matrix.copy(rt.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),ve===!0&&H.cameras.push(rt)}let _e=s.enabledFeatures;if(_e&&_e.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let Ue=u.getDepthInformation(ge[0]);Ue&&Ue.isValid&&Ue.texture&&p.init(Ue,s.renderState)}if(_e&&_e.includes("camera-access")&&y){e.state.unbindTexture(),u=n.getBinding();for(let Ue=0;Ue<ge.length;Ue++){let st=ge[Ue].camera;if(st){let ct=m[st];ct||(ct=new rl,m[st]=ct);let rt=u.getCameraImage(st);ct.sourceTexture=rt}}}}for(let ge=0;ge<R.length;ge++){let ve=T[ge],_e=R[ge];ve!==null&&_e!==void 0&&_e.update(ve,me,c||o)}ie&&ie(ee,me),me.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:me}),g=null}let ue=new q_;ue.setAnimationLoop(de),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},cA=new Rt,nv=new it;nv.set(-1,0,0,0,1,0,0,0,1);function hA(i,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function n(p,m){m.color.getRGB(p.fogColor.value,Pp(i)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,x,C,M){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,M)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),y(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,x,C):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===ii&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===ii&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let x=e.get(m),C=x.envMap,M=x.envMapRotation;C&&(p.envMap.value=C,p.envMapRotation.value.setFromMatrix4(cA.makeRotationFromEuler(M)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(nv),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,x,C){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*x,p.scale.value=C*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,x){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ii&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=x.texture,p.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){let x=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(x.matrixWorld),p.nearDistance.value=x.shadow.camera.near,p.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function uA(i,e,t,n){let s={},r={};function o(x,C){let M=C.program;n.uniformBlockBinding(x,M,s[x.id])}function a(x,C){let M=s[x.id];M===void 0&&(g(x),M=l(x),s[x.id]=M,x.addEventListener("dispose",p));let R=C.program;n.updateUBOMapping(x,R);let T=e.render.frame;r[x.id]!==T&&(c(x),r[x.id]=T)}function l(x){let C=i.createBuffer(),M=x.__size,R=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,C),i.bufferData(i.UNIFORM_BUFFER,M,R),i.bindBuffer(i.UNIFORM_BUFFER,null),C}function c(x){let C=s[x.id],M=x.uniforms,R=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,C);for(let T=0,v=M.length;T<v;T++){let E=M[T];if(Array.isArray(E))for(let z=0,k=E.length;z<k;z++)h(E[z],T,z,R);else h(E,T,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(x,C,M,R){if(d(x,C,M,R)===!0){let T=x.__offset,v=x.value;if(Array.isArray(v)){let E=0;for(let z=0;z<v.length;z++){let k=v[z],N=y(k,!0);u(k,x.__data,E),E+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,T,x.__data)}}function u(x,C,M){typeof x=="number"||typeof x=="boolean"?C[M]=x:x.isMatrix3?(C[M]=x.elements[0],C[M+1]=x.elements[1],C[M+2]=x.elements[2],C[M+3]=0,C[M+4]=x.elements[3],C[M+5]=x.elements[4],C[M+6]=x.elements[5],C[M+7]=0,C[M+8]=x.elements[6],C[M+9]=x.elements[7],C[M+10]=x.elements[8],C[M+11]=0):ArrayBuffer.isView(x)?C.set(x.subarray(0,C.length-M),M):x.toArray(C,M)}function d(x,C,M,R){let T=x.value,v=C+"_"+M;if(Array.isArray(T)){R[v]===void 0&&(R[v]=[]);let E=R[v],z=!1;for(let k=0;k<T.length;k++)f(T[k],E,k)===!0&&(z=!0);return z}return f(T,R,v)}function f(x,C,M){if(C[M]===void 0)return typeof x=="number"||typeof x=="boolean"?C[M]=x:ArrayBuffer.isView(x)?C[M]=x.slice():C[M]=x.clone(),!0;{let R=C[M];if(typeof x=="number"||typeof x=="boolean"){if(R!==x)return C[M]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(R.equals(x)===!1)return R.copy(x),!0}}return!1}function g(x){let C=x.uniforms,M=0,R=16;for(let v=0,E=C.length;v<E;v++){let z=Array.isArray(C[v])?C[v]:[C[v]];for(let k=0,N=z.length;k<N;k++){let W=z[k],H=Array.isArray(W.value)?W.value:[W.value],I=Array.isArray(C[v])||Array.isArray(W.value),F=M;for(let V=0,le=H.length;V<le;V++){let Z=H[V],Q=y(Z,I),ie=M%R,de=ie%Q.boundary,ue=ie+de;M+=de,ue!==0&&R-ue<Q.storage&&(M+=R-ue),V===0&&(F=M),M+=Q.storage}let q=W.type==="int"?Int32Array:W.type==="uint"?Uint32Array:Float32Array;W.__data=new q((M-F)/Float32Array.BYTES_PER_ELEMENT),W.__offset=F}}let T=M%R;return T>0&&(M+=R-T),x.__size=M,x.__cache={},this}function y(x,C){let M={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(M.boundary=4,M.storage=4):x.isVector2?(M.boundary=8,M.storage=8):x.isVector3||x.isColor?(M.boundary=16,M.storage=12):x.isVector4?(M.boundary=16,M.storage=16):x.isMatrix3?(M.boundary=16,M.storage=48):x.isMatrix4?(M.boundary=16,M.storage=64):x.isTexture?$e("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(M.boundary=16,M.storage=x.byteLength):$e("WebGLRenderer: Unsupported uniform value type.",x),C===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function p(x){let C=x.target;C.removeEventListener("dispose",p),i.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function m(){for(let x in s)i.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:m}}var dA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),_s=null;function fA(){return _s===null&&(_s=new kr(dA,16,16,vr,$i),_s.name="DFG_LUT",_s.minFilter=ti,_s.magFilter=ti,_s.wrapS=ds,_s.wrapT=ds,_s.generateMipmaps=!1,_s.needsUpdate=!0),_s}var ou=class{constructor(e={}){let{canvas:t=m_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=li}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let y=f,p=new Set([Th,Mh,Sh]),m=new Set([li,qi,Yo,Vr,xh,bh]),x=new Uint32Array(4),C=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},R=null,T=null,v=[],E=[],z=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=gs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let k=this,N=!1,W=null,H=null,I=null,F=null;this._outputColorSpace=Qn;let q=0,V=0,le=null,Z=-1,Q=null,ie=new Zt,de=new Zt,ue=null,ee=new ut(0),me=0,ge=t.width,ve=t.height,_e=1,Ge=null,Ze=null,Ue=new Zt(0,0,ge,ve),st=new Zt(0,0,ge,ve),ct=!1,rt=new hr,Yt=new Zc,zt=!1,dn=!1,kt=new Rt,Rn=new $,wt=new Zt,Sn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},nn=!1;function fn(){return le===null?_e:1}let U=n;function Pe(S,B){return t.getContext(S,B)}let Ye,lt,Me,Ut,He,qe,P,b,X,he,oe,xe,be,te,se,pe,O,re,ne,Te,ye,Se,We;try{let S={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",Qe,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),U===null){let B="webgl2";if(U=Pe(B,S),U===null)throw Pe(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(S){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),nt("WebGLRenderer: "+S.message),S}function je(){Ye=new MT(U),Ye.init(),ye=new oA(U,Ye),lt=new fT(U,Ye,e,ye),Me=new sA(U,Ye),lt.reversedDepthBuffer&&d&&Me.buffers.depth.setReversed(!0),H=U.createFramebuffer(),I=U.createFramebuffer(),F=U.createFramebuffer(),Ut=new AT(U),He=new WE,qe=new rA(U,Ye,Me,He,lt,ye,Ut),P=new ST(k),b=new PS(U),Se=new uT(U,b),X=new TT(U,b,Ut,Se),he=new PT(U,X,b,Se,Ut),re=new CT(U,lt,qe),se=new pT(He),oe=new HE(k,P,Ye,lt,Se,se),xe=new hA(k,He),be=new qE,te=new jE(Ye),O=new hT(k,P,Me,he,g,l),pe=new iA(k,he,lt),We=new uA(U,Ut,lt,Me),ne=new dT(U,Ye,Ut),Te=new ET(U,Ye,Ut),Ut.programs=oe.programs,k.capabilities=lt,k.extensions=Ye,k.properties=He,k.renderLists=be,k.shadowMap=pe,k.state=Me,k.info=Ut}y!==li&&(z=new LT(y,t.width,t.height,a,s,r));let ce=new $p(k,U);this.xr=ce,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let S=Ye.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=Ye.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return _e},this.setPixelRatio=function(S){S!==void 0&&(_e=S,this.setSize(ge,ve,!1))},this.getSize=function(S){return S.set(ge,ve)},this.setSize=function(S,B,j=!0){if(ce.isPresenting){$e("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=S,ve=B,t.width=Math.floor(S*_e),t.height=Math.floor(B*_e),j===!0&&(t.style.width=S+"px",t.style.height=B+"px"),z!==null&&z.setSize(t.width,t.height),this.setViewport(0,0,S,B)},this.getDrawingBufferSize=function(S){return S.set(ge*_e,ve*_e).floor()},this.setDrawingBufferSize=function(S,B,j){ge=S,ve=B,_e=j,t.width=Math.floor(S*j),t.height=Math.floor(B*j),this.setViewport(0,0,S,B)},this.setEffects=function(S){if(y===li){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(S){for(let B=0;B<S.length;B++)if(S[B].isOutputPass===!0){$e("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}z.setEffects(S||[])},this.getCurrentViewport=function(S){return S.copy(ie)},this.getViewport=function(S){return S.copy(Ue)},this.setViewport=function(S,B,j,Y){S.isVector4?Ue.set(S.x,S.y,S.z,S.w):Ue.set(S,B,j,Y),Me.viewport(ie.copy(Ue).multiplyScalar(fn()).round())},this.getScissor=function(S){return S.copy(st)},this.setScissor=function(S,B,j,Y){S.isVector4?st.set(S.x,S.y,S.z,S.w):st.set(S,B,j,Y),Me.scissor(de.copy(st).multiplyScalar(fn()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(S){Me.setScissorTest(ct=S)},this.setOpaqueSort=function(S){Ge=S},this.setTransparentSort=function(S){Ze=S},this.getClearColor=function(S){return S.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(S=!0,B=!0,j=!0){let Y=0;if(S){let K=!1;if(le!==null){let Ee=le.texture.format;K=p.has(Ee)}if(K){let Ee=le.texture.type,Re=m.has(Ee),Ae=O.getClearColor(),Le=O.getClearAlpha(),Ve=Ae.r,tt=Ae.g,mt=Ae.b;Re?(x[0]=Ve,x[1]=tt,x[2]=mt,x[3]=Le,U.clearBufferuiv(U.COLOR,0,x)):(C[0]=Ve,C[1]=tt,C[2]=mt,C[3]=Le,U.clearBufferiv(U.COLOR,0,C))}else Y|=U.COLOR_BUFFER_BIT}B&&(Y|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&U.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(S){S.setRenderer(this),W=S},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),O.dispose(),be.dispose(),te.dispose(),qe.dispose(),He.dispose(),P.dispose(),he.dispose(),X.dispose(),Se.dispose(),We.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",sc),ce.removeEventListener("sessionend",is),Cs.stop()};function Be(S){S.preventDefault(),Mp("WebGLRenderer: Context Lost."),N=!0}function Qe(){Mp("WebGLRenderer: Context Restored."),N=!1;let S=Ut.autoReset,B=pe.enabled,j=pe.autoUpdate,Y=pe.needsUpdate,K=pe.type;je(),Ut.autoReset=S,pe.enabled=B,pe.autoUpdate=j,pe.needsUpdate=Y,pe.type=K}function Ce(S){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function ht(S){let B=S.target;B.removeEventListener("dispose",ht),Vt(B)}function Vt(S){Yn(S),He.remove(S)}function Yn(S){let B=He.get(S).programs;B!==void 0&&(B.forEach(function(j){oe.releaseProgram(j)}),S.isShaderMaterial&&oe.releaseShaderCache(S))}this.renderBufferDirect=function(S,B,j,Y,K,Ee){B===null&&(B=Sn);let Re=K.isMesh&&K.matrixWorld.determinantAffine()<0,Ae=Pa(S,B,j,Y,K);Me.setMaterial(Y,Re);let Le=j.index,Ve=1;if(Y.wireframe===!0){if(Le=X.getWireframeAttribute(j),Le===void 0)return;Ve=2}let tt=j.drawRange,mt=j.attributes.position,ze=tt.start*Ve,gt=(tt.start+tt.count)*Ve;Ee!==null&&(ze=Math.max(ze,Ee.start*Ve),gt=Math.min(gt,(Ee.start+Ee.count)*Ve)),Le!==null?(ze=Math.max(ze,0),gt=Math.min(gt,Le.count)):mt!=null&&(ze=Math.max(ze,0),gt=Math.min(gt,mt.count));let Qt=gt-ze;if(Qt<0||Qt===1/0)return;Se.setup(K,Y,Ae,j,Le);let It,Dt=ne;if(Le!==null&&(It=b.get(Le),Dt=Te,Dt.setIndex(It)),K.isMesh)Y.wireframe===!0?(Me.setLineWidth(Y.wireframeLinewidth*fn()),Dt.setMode(U.LINES)):Dt.setMode(U.TRIANGLES);else if(K.isLine){let Mn=Y.linewidth;Mn===void 0&&(Mn=1),Me.setLineWidth(Mn*fn()),K.isLineSegments?Dt.setMode(U.LINES):K.isLineLoop?Dt.setMode(U.LINE_LOOP):Dt.setMode(U.LINE_STRIP)}else K.isPoints?Dt.setMode(U.POINTS):K.isSprite&&Dt.setMode(U.TRIANGLES);if(K.isBatchedMesh)if(Ye.get("WEBGL_multi_draw"))Dt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let Mn=K._multiDrawStarts,Oe=K._multiDrawCounts,pn=K._multiDrawCount,yt=Le?b.get(Le).bytesPerElement:1,Rs=He.get(Y).currentProgram.getUniforms();for(let mn=0;mn<pn;mn++)Rs.setValue(U,"_gl_DrawID",mn),Dt.render(Mn[mn]/yt,Oe[mn])}else if(K.isInstancedMesh)Dt.renderInstances(ze,Qt,K.count);else if(j.isInstancedBufferGeometry){let Mn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Oe=Math.min(j.instanceCount,Mn);Dt.renderInstances(ze,Qt,Oe)}else Dt.render(ze,Qt)};function Ea(S,B,j,Y){W!==null&&S.isNodeMaterial&&W.setObject(Y,S),zt===!0&&se.setState(S,j,!1),S.transparent===!0&&S.side===ai&&S.forceSinglePass===!1?(S.side=ii,S.needsUpdate=!0,ss(S,B,Y),S.side=_r,S.needsUpdate=!0,ss(S,B,Y),S.side=ai):ss(S,B,Y)}this.compile=function(S,B,j=null){j===null&&(j=S),W!==null&&W.renderStart(S,B,j),T=te.get(j),T.init(B),E.push(T),j.traverseVisible(function(K){K.isLight&&K.layers.test(B.layers)&&(T.pushLight(K),K.castShadow&&T.pushShadow(K))}),S!==j&&S.traverseVisible(function(K){K.isLight&&K.layers.test(B.layers)&&(T.pushLight(K),K.castShadow&&T.pushShadow(K))}),T.setupLights(),W!==null&&W.updateLights(T.state.lightsArray),dn=this.localClippingEnabled,zt=se.init(this.clippingPlanes,dn),zt===!0&&se.setGlobalState(this.clippingPlanes,B),W!==null&&pe.render(T.state.shadowsArray,j,B);let Y=new Set;return S.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ee=K.material;if(Ee)if(Array.isArray(Ee))for(let Re=0;Re<Ee.length;Re++){let Ae=Ee[Re];Ea(Ae,j,B,K),Y.add(Ae)}else Ea(Ee,j,B,K),Y.add(Ee)}),T=E.pop(),W!==null&&W.renderEnd(),Y},this.compileAsync=function(S,B,j=null){let Y=this.compile(S,B,j);return new Promise(K=>{function Ee(){if(Y.forEach(function(Re){let Le=He.get(Re).currentProgram;(Le===void 0||Le.isReady())&&Y.delete(Re)}),Y.size===0){K(S);return}setTimeout(Ee,10)}Ye.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let co=null;function mf(S){co&&co(S)}function sc(){Cs.stop()}function is(){Cs.start()}let Cs=new q_;Cs.setAnimationLoop(mf),typeof self<"u"&&Cs.setContext(self),this.setAnimationLoop=function(S){co=S,ce.setAnimationLoop(S),S===null?Cs.stop():Cs.start()},ce.addEventListener("sessionstart",sc),ce.addEventListener("sessionend",is),this.render=function(S,B){if(B!==void 0&&B.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;W!==null&&W.renderStart(S,B);let j=ce.enabled===!0&&ce.isPresenting===!0,Y=z!==null&&(le===null||j)&&z.begin(k,le);if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(z===null||z.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(B),B=ce.getCamera()),S.isScene===!0&&S.onBeforeRender(k,S,B,le),T=te.get(S,E.length),T.init(B),T.state.textureUnits=qe.getTextureUnits(),E.push(T),kt.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?Yt.setFromArrayCamera(B):rt.setFromProjectionMatrix(kt,Ai,B.reversedDepth),dn=this.localClippingEnabled,zt=se.init(this.clippingPlanes,dn),R=be.get(S,v.length),R.init(),v.push(R),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Re=k.xr.getDepthSensingMesh();Re!==null&&Ps(Re,B,-1/0,k.sortObjects)}Ps(S,B,0,k.sortObjects),R.finish(),W!==null&&W.updateLights(T.state.lightsArray),k.sortObjects===!0&&R.sort(Ge,Ze),nn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,nn&&O.addToRenderList(R,S),this.info.autoReset===!0&&this.info.reset(),zt===!0&&se.beginShadows();let K=T.state.shadowsArray;if(pe.render(K,S,B),zt===!0&&se.endShadows(),(Y&&z.hasRenderPass())===!1){let Re=R.opaque,Ae=R.transmissive;if(T.setupLights(),B.isArrayCamera){let Le=B.cameras;if(Ae.length>0)for(let Ve=0,tt=Le.length;Ve<tt;Ve++){let mt=Le[Ve];Ui(Re,Ae,S,mt)}nn&&O.render(S);for(let Ve=0,tt=Le.length;Ve<tt;Ve++){let mt=Le[Ve];Aa(R,S,mt,mt.viewport)}}else Ae.length>0&&Ui(Re,Ae,S,B),nn&&O.render(S),Aa(R,S,B)}le!==null&&V===0&&(qe.updateMultisampleRenderTarget(le),qe.updateRenderTargetMipmap(le)),Y&&z.end(k),S.isScene===!0&&S.onAfterRender(k,S,B),Se.resetDefaultState(),Z=-1,Q=null,E.pop(),E.length>0?(T=E[E.length-1],qe.setTextureUnits(T.state.textureUnits),zt===!0&&se.setGlobalState(k.clippingPlanes,T.state.camera)):T=null,v.pop(),v.length>0?R=v[v.length-1]:R=null,W!==null&&W.renderEnd()};function Ps(S,B,j,Y){if(S.visible===!1)return;if(S.layers.test(B.layers)){if(S.isGroup)j=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(B);else if(S.isLight)T.pushLight(S),S.castShadow&&T.pushShadow(S);else if(S.isSprite){let Re=B.isArrayCamera?Yt:rt;if(!S.frustumCulled||S.intersectsFrustum(Re)){Y&&wt.setFromMatrixPosition(S.matrixWorld).applyMatrix4(kt);let Ae=he.update(S),Le=S.material;Le.visible&&R.push(S,Ae,Le,j,wt.z,null,B)}}else if(S.isMesh||S.isLine||S.isPoints){let Re=B.isArrayCamera?Yt:rt;if(!S.frustumCulled||S.intersectsFrustum(Re)){let Ae=he.update(S),Le=S.material;if(Y&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),wt.copy(S.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),wt.copy(Ae.boundingSphere.center)),wt.applyMatrix4(S.matrixWorld).applyMatrix4(kt)),Array.isArray(Le)){let Ve=Ae.groups;for(let tt=0,mt=Ve.length;tt<mt;tt++){let ze=Ve[tt],gt=Le[ze.materialIndex];gt&&gt.visible&&R.push(S,Ae,gt,j,wt.z,ze,B)}}else Le.visible&&R.push(S,Ae,Le,j,wt.z,null,B)}}}let Ee=S.children;for(let Re=0,Ae=Ee.length;Re<Ae;Re++)Ps(Ee[Re],B,j,Y)}function Aa(S,B,j,Y){let{opaque:K,transmissive:Ee,transparent:Re}=S;T.setupLightsView(j),zt===!0&&se.setGlobalState(k.clippingPlanes,j),Y&&Me.viewport(ie.copy(Y)),K.length>0&&sn(K,B,j),Ee.length>0&&sn(Ee,B,j),Re.length>0&&sn(Re,B,j),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function Ui(S,B,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[Y.id]===void 0){let ze=Ye.has("EXT_color_buffer_half_float")||Ye.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[Y.id]=new yi(1,1,{generateMipmaps:!0,type:ze?$i:li,minFilter:Xs,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:xt.workingColorSpace})}let Ee=T.state.transmissionRenderTarget[Y.id],Re=Y.viewport||ie;Ee.setSize(Re.z*k.transmissionResolutionScale,Re.w*k.transmissionResolutionScale);let Ae=k.getRenderTarget(),Le=k.getActiveCubeFace(),Ve=k.getActiveMipmapLevel();k.setRenderTarget(Ee),k.getClearColor(ee),me=k.getClearAlpha(),me<1&&k.setClearColor(16777215,.5),k.clear(),nn&&O.render(j);let tt=k.toneMapping;k.toneMapping=gs;let mt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),T.setupLightsView(Y),zt===!0&&se.setGlobalState(k.clippingPlanes,Y),sn(S,j,Y),qe.updateMultisampleRenderTarget(Ee),qe.updateRenderTargetMipmap(Ee),Ye.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let gt=0,Qt=B.length;gt<Qt;gt++){let It=B[gt],{object:Dt,geometry:Mn,material:Oe,group:pn}=It;if(Oe.side===ai&&Dt.layers.test(Y.layers)){let yt=Oe.side;Oe.side=ii,Oe.needsUpdate=!0,cn(Dt,j,Y,Mn,Oe,pn),Oe.side=yt,Oe.needsUpdate=!0,ze=!0}}ze===!0&&(qe.updateMultisampleRenderTarget(Ee),qe.updateRenderTargetMipmap(Ee))}k.setRenderTarget(Ae,Le,Ve),k.setClearColor(ee,me),mt!==void 0&&(Y.viewport=mt),k.toneMapping=tt}function sn(S,B,j){let Y=B.isScene===!0?B.overrideMaterial:null;for(let K=0,Ee=S.length;K<Ee;K++){let Re=S[K],{object:Ae,geometry:Le,group:Ve}=Re,tt=Re.material;tt.allowOverride===!0&&Y!==null&&(tt=Y),Ae.layers.test(j.layers)&&cn(Ae,B,j,Le,tt,Ve)}}function cn(S,B,j,Y,K,Ee){W!==null&&K.isNodeMaterial&&W.setObject(S,K),S.onBeforeRender(k,B,j,Y,K,Ee),S.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),K.onBeforeRender(k,B,j,Y,S,Ee),K.transparent===!0&&K.side===ai&&K.forceSinglePass===!1?(K.side=ii,K.needsUpdate=!0,k.renderBufferDirect(j,B,Y,K,S,Ee),K.side=_r,K.needsUpdate=!0,k.renderBufferDirect(j,B,Y,K,S,Ee),K.side=ai):k.renderBufferDirect(j,B,Y,K,S,Ee),S.onAfterRender(k,B,j,Y,K,Ee)}function hn(S){let B=0;for(let j of S)j.texture!==null&&B++;return B}function ss(S,B,j){B.isScene!==!0&&(B=Sn);let Y=He.get(S),K=T.state.lights,Ee=T.state.shadowsArray,Re=K.state.version,Ae=oe.getParameters(S,K.state,Ee,B,j,T.state.lightProbeGridArray),Le=oe.getProgramCacheKey(Ae),Ve=Y.programs;Y.environment=S.isMeshStandardMaterial||S.isMeshLambertMaterial||S.isMeshPhongMaterial?B.environment:null,Y.fog=B.fog;let tt=S.isMeshStandardMaterial||S.isMeshLambertMaterial&&!S.envMap||S.isMeshPhongMaterial&&!S.envMap;Y.envMap=P.get(S.envMap||Y.environment,tt),Y.envMapRotation=Y.environment!==null&&S.envMap===null?B.environmentRotation:S.envMapRotation,Ve===void 0&&(S.addEventListener("dispose",ht),Ve=new Map,Y.programs=Ve,Y.programVariants=new Map);let mt=Ve.get(Le);if(mt!==void 0){if(Y.currentProgram===mt&&Y.lightsStateVersion===Re)return Ca(S,Ae),mt}else Ae.uniforms=oe.getUniforms(S),W!==null&&S.isNodeMaterial&&W.build(S,j,Ae),S.onBeforeCompile(Ae,k),mt=oe.acquireProgram(Ae,Le),Ve.set(Le,mt),Y.uniforms=Ae.uniforms;let ze=Y.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(ze.clippingPlanes=se.uniform),Ca(S,Ae),Y.needsLights=Qs(S),Y.lightsStateVersion=Re,Y.needsLights&&(ze.ambientLightColor.value=K.state.ambient,ze.lightProbe.value=K.state.probe,ze.sunLights.value=K.state.sun,ze.sunLightShadows.value=K.state.sunShadow,ze.directionalLights.value=K.state.directional,ze.directionalLightShadows.value=K.state.directionalShadow,ze.spotLights.value=K.state.spot,ze.spotLightShadows.value=K.state.spotShadow,ze.rectAreaLights.value=K.state.rectArea,ze.ltc_1.value=K.state.rectAreaLTC1,ze.ltc_2.value=K.state.rectAreaLTC2,ze.pointLights.value=K.state.point,ze.pointLightShadows.value=K.state.pointShadow,ze.hemisphereLights.value=K.state.hemi,ze.sunShadowMatrix.value=K.state.sunShadowMatrix,ze.sunShadowCascade.value=K.state.sunShadowCascade,ze.directionalShadowMatrix.value=K.state.directionalShadowMatrix,ze.spotLightMatrix.value=K.state.spotLightMatrix,ze.spotLightMap.value=K.state.spotLightMap,ze.pointShadowMatrix.value=K.state.pointShadowMatrix),Y.numLightProbeGrids=hn(T.state.lightProbeGridArray),Y.currentProgram=mt,Y.uniformsList=null,mt}function di(S,B,j,Y,K){let Ee=He.get(S),Re=Ee.currentProgram.id+","+Y+","+K,Ae=Ee.programVariants.get(Re);return Ae===void 0?(Ae=ss(S,B,j),Ee.programVariants.set(Re,Ae)):(Ee.currentProgram=Ae,Ee.uniformsList=null,Ee.outputColorSpace=Y,Ee.toneMapping=K),Ae}function js(S){if(S.uniformsList===null){let B=S.currentProgram.getUniforms();S.uniformsList=Zo.seqWithValue(B.seq,S.uniforms)}return S.uniformsList}function Ca(S,B){let j=He.get(S);j.outputColorSpace=B.outputColorSpace,j.batching=B.batching,j.batchingColor=B.batchingColor,j.instancing=B.instancing,j.instancingColor=B.instancingColor,j.instancingMorph=B.instancingMorph,j.skinning=B.skinning,j.morphTargets=B.morphTargets,j.morphNormals=B.morphNormals,j.morphColors=B.morphColors,j.morphTargetsCount=B.morphTargetsCount,j.numClippingPlanes=B.numClippingPlanes,j.numIntersection=B.numClipIntersection,j.vertexAlphas=B.vertexAlphas,j.vertexTangents=B.vertexTangents,j.toneMapping=B.toneMapping}function Pa(S,B,j,Y,K){B.isScene!==!0&&(B=Sn),qe.resetTextureUnits();let Ee=B.fog,Re=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?B.environment:null,Ae=le===null?k.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:xt.workingColorSpace,Le=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ve=P.get(Y.envMap||Re,Le),tt=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,mt=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),ze=!!j.morphAttributes.position,gt=!!j.morphAttributes.normal,Qt=!!j.morphAttributes.color,It=gs;Y.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(It=k.toneMapping);let Dt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Mn=Dt!==void 0?Dt.length:0,Oe=He.get(Y),pn=T.state.lights;if(zt===!0&&(dn===!0||S!==Q)){let Nt=S===Q&&Y.id===Z;se.setState(Y,S,Nt)}let yt=!1,Rs=!1;Y.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==pn.state.version||K.isBatchedMesh&&Oe.batching===!1||!K.isBatchedMesh&&Oe.batching===!0||K.isBatchedMesh&&Oe.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Oe.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Oe.instancing===!1||!K.isInstancedMesh&&Oe.instancing===!0||K.isSkinnedMesh&&Oe.skinning===!1||!K.isSkinnedMesh&&Oe.skinning===!0||K.isInstancedMesh&&Oe.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Oe.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Oe.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Oe.instancingMorph===!1&&K.morphTexture!==null||Oe.envMap!==Ve||Y.fog===!0&&Oe.fog!==Ee||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==se.numPlanes||Oe.numIntersection!==se.numIntersection)||Oe.vertexAlphas!==tt||Oe.vertexTangents!==mt||Oe.morphTargets!==ze||Oe.morphNormals!==gt||Oe.morphColors!==Qt||Oe.morphTargetsCount!==Mn||Oe.numLightProbeGrids!==hn(T.state.lightProbeGridArray)?yt=!0:(Oe.outputColorSpace!==Ae||Oe.toneMapping!==It)&&(Rs=!0):(yt=!0,Oe.__version=Y.version);let mn=Oe.currentProgram;(yt===!0||Rs===!0)&&(mn=Rs===!0?di(Y,B,K,Ae,It):ss(Y,B,K),W&&Y.isNodeMaterial&&W.onUpdateProgram(Y,mn,Oe));let fo=!1,rs=!1,Ls=!1,dt=mn.getUniforms(),rn=Oe.uniforms;if(Me.useProgram(mn.program)&&(fo=!0,rs=!0,Ls=!0),Y.id!==Z&&(Z=Y.id,rs=!0),fo||Q!==S){Me.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),dt.setValue(U,"projectionMatrix",S.projectionMatrix),dt.setValue(U,"viewMatrix",S.matrixWorldInverse);let gn=dt.map.cameraPosition;gn!==void 0&&gn.setValue(U,Rn.setFromMatrixPosition(S.matrixWorld)),lt.logarithmicDepthBuffer&&dt.setValue(U,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&dt.setValue(U,"isOrthographic",S.isOrthographicCamera===!0),Q!==S&&(Q=S,rs=!0,Ls=!0)}if(Oe.needsLights&&(pn.state.sunShadowMap.length>0&&dt.setValue(U,"sunShadowMap",pn.state.sunShadowMap,qe),pn.state.directionalShadowMap.length>0&&dt.setValue(U,"directionalShadowMap",pn.state.directionalShadowMap,qe),pn.state.spotShadowMap.length>0&&dt.setValue(U,"spotShadowMap",pn.state.spotShadowMap,qe),pn.state.pointShadowMap.length>0&&dt.setValue(U,"pointShadowMap",pn.state.pointShadowMap,qe)),K.isSkinnedMesh){dt.setOptional(U,K,"bindMatrix"),dt.setOptional(U,K,"bindMatrixInverse");let Nt=K.skeleton;Nt&&(Nt.boneTexture===null&&Nt.computeBoneTexture(),dt.setValue(U,"boneTexture",Nt.boneTexture,qe))}K.isBatchedMesh&&(dt.setOptional(U,K,"batchingTexture"),dt.setValue(U,"batchingTexture",K._matricesTexture,qe),dt.setOptional(U,K,"batchingIdTexture"),dt.setValue(U,"batchingIdTexture",K._indirectTexture,qe),dt.setOptional(U,K,"batchingColorTexture"),K._colorsTexture!==null&&dt.setValue(U,"batchingColorTexture",K._colorsTexture,qe));let Kn=j.morphAttributes;if((Kn.position!==void 0||Kn.normal!==void 0||Kn.color!==void 0)&&re.update(K,j,mn),(rs||Oe.receiveShadow!==K.receiveShadow)&&(Oe.receiveShadow=K.receiveShadow,dt.setValue(U,"receiveShadow",K.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&B.environment!==null&&(rn.envMapIntensity.value=B.environmentIntensity),rn.dfgLUT!==void 0&&(rn.dfgLUT.value=fA()),rs){if(dt.setValue(U,"toneMappingExposure",k.toneMappingExposure),Oe.needsLights&&ho(rn,Ls),Ee&&Y.fog===!0&&xe.refreshFogUniforms(rn,Ee),xe.refreshMaterialUniforms(rn,Y,_e,ve,T.state.transmissionRenderTarget[S.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let Nt=M,gn=0;for(let Wn of T.state.lightProbeGridArray)Wn.texture!==null&&(Nt.textures[gn]=Wn.texture,Nt.min[gn]=Wn.boundingBox.min,Nt.max[gn]=Wn.boundingBox.max,Nt.resolution[gn]=Wn.resolution,gn++);for(let Wn in Nt)Nt[Wn].length=gn;rn.probesSH.value=Nt.textures,rn.probesMin.value=Nt.min,rn.probesMax.value=Nt.max,rn.probesResolution.value=Nt.resolution}Zo.upload(U,js(Oe),rn,qe)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Zo.upload(U,js(Oe),rn,qe),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&dt.setValue(U,"center",K.center),dt.setValue(U,"modelViewMatrix",K.modelViewMatrix),dt.setValue(U,"normalMatrix",K.normalMatrix),dt.setValue(U,"modelMatrix",K.matrixWorld),Y.uniformsGroups!==void 0){let Nt=Y.uniformsGroups;for(let gn=0,Wn=Nt.length;gn<Wn;gn++){let rc=Nt[gn];We.update(rc,mn),We.bind(rc,mn)}}return mn}function ho(S,B){S.ambientLightColor.needsUpdate=B,S.lightProbe.needsUpdate=B,S.sunLights.needsUpdate=B,S.sunLightShadows.needsUpdate=B,S.directionalLights.needsUpdate=B,S.directionalLightShadows.needsUpdate=B,S.pointLights.needsUpdate=B,S.pointLightShadows.needsUpdate=B,S.spotLights.needsUpdate=B,S.spotLightShadows.needsUpdate=B,S.rectAreaLights.needsUpdate=B,S.hemisphereLights.needsUpdate=B}function Qs(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(S,B,j){let Y=He.get(S);Y.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),He.get(S.texture).__webglTexture=B,He.get(S.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,B){let j=He.get(S);j.__webglFramebuffer=B,j.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(S,B=0,j=0){le=S,q=B,V=j;let Y=null,K=!1,Ee=!1;if(S){let Ae=He.get(S);if(Ae.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(U.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(S.viewport),de.copy(S.scissor),ue=S.scissorTest,Me.viewport(ie),Me.scissor(de),Me.setScissorTest(ue),Z=-1;return}else if(Ae.__webglFramebuffer===void 0)qe.setupRenderTarget(S);else if(Ae.__hasExternalTextures)qe.rebindTextures(S,He.get(S.texture).__webglTexture,He.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let tt=S.depthTexture;if(Ae.__boundDepthTexture!==tt){if(tt!==null&&He.has(tt)&&(S.width!==tt.image.width||S.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qe.setupDepthRenderbuffer(S)}}let Le=S.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(Ee=!0);let Ve=He.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(Ve[B])?Y=Ve[B][j]:Y=Ve[B],K=!0):S.samples>0&&qe.useMultisampledRTT(S)===!1?Y=He.get(S).__webglMultisampledFramebuffer:Array.isArray(Ve)?Y=Ve[j]:Y=Ve,ie.copy(S.viewport),de.copy(S.scissor),ue=S.scissorTest}else ie.copy(Ue).multiplyScalar(_e).floor(),de.copy(st).multiplyScalar(_e).floor(),ue=ct;if(j!==0&&(Y=H),Me.bindFramebuffer(U.FRAMEBUFFER,Y)&&Me.drawBuffers(S,Y),Me.viewport(ie),Me.scissor(de),Me.setScissorTest(ue),K){let Ae=He.get(S.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+B,Ae.__webglTexture,j)}else if(Ee){let Ae=B;for(let Le=0;Le<S.textures.length;Le++){let Ve=He.get(S.textures[Le]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+Le,Ve.__webglTexture,j,Ae)}}else if(S!==null&&j!==0){let Ae=He.get(S.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Ae.__webglTexture,j)}Z=-1};function uo(S){let B=He.get(S);return(B.__readFormat!==S.format||B.__readType!==S.type)&&(B.__readFormat=S.format,B.__readType=S.type,B.__formatReadable=lt.textureFormatReadable(S.format),B.__typeReadable=lt.textureTypeReadable(S.type)),B}this.readRenderTargetPixels=function(S,B,j,Y,K,Ee,Re,Ae=0){if(!(S&&S.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=He.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Re!==void 0&&(Le=Le[Re],Array.isArray(Le)&&(Le=Le[0])),Le){Me.bindFramebuffer(U.FRAMEBUFFER,Le);try{let Ve=S.textures[Ae],tt=Ve.format,mt=Ve.type;S.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Ae);let ze=uo(Ve);if(ze.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=S.width-Y&&j>=0&&j<=S.height-K&&U.readPixels(B,j,Y,K,ye.convert(tt),ye.convert(mt),Ee)}finally{let Ve=le!==null?He.get(le).__webglFramebuffer:null;Me.bindFramebuffer(U.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(S,B,j,Y,K,Ee,Re,Ae=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=He.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Re!==void 0&&(Le=Le[Re],Array.isArray(Le)&&(Le=Le[0])),Le)if(B>=0&&B<=S.width-Y&&j>=0&&j<=S.height-K){Me.bindFramebuffer(U.FRAMEBUFFER,Le);let Ve=S.textures[Ae],tt=Ve.format,mt=Ve.type;S.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Ae);let ze=uo(Ve);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let gt=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,gt),U.bufferData(U.PIXEL_PACK_BUFFER,Ee.byteLength,U.STREAM_READ),U.readPixels(B,j,Y,K,ye.convert(tt),ye.convert(mt),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let Qt=le!==null?He.get(le).__webglFramebuffer:null;Me.bindFramebuffer(U.FRAMEBUFFER,Qt);let It=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await __(U,It,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,gt),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,Ee),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(gt),U.deleteSync(It),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,B=null,j=0){let Y=Math.pow(2,-j),K=Math.floor(S.image.width*Y),Ee=Math.floor(S.image.height*Y),Re=B!==null?B.x:0,Ae=B!==null?B.y:0;qe.setTexture2D(S,0),U.copyTexSubImage2D(U.TEXTURE_2D,j,0,0,Re,Ae,K,Ee),Me.unbindTexture()},this.copyTextureToTexture=function(S,B,j=null,Y=null,K=0,Ee=0){let Re,Ae,Le,Ve,tt,mt,ze,gt,Qt,It=S.isCompressedTexture?S.mipmaps[Ee]:S.image;if(j!==null)Re=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Le=j.isBox3?j.max.z-j.min.z:1,Ve=j.min.x,tt=j.min.y,mt=j.isBox3?j.min.z:0;else{let dt=Math.pow(2,-K);Re=Math.floor(It.width*dt),Ae=Math.floor(It.height*dt),S.isDataArrayTexture?Le=It.depth:S.isData3DTexture?Le=Math.floor(It.depth*dt):Le=1,Ve=0,tt=0,mt=0}Y!==null?(ze=Y.x,gt=Y.y,Qt=Y.z):(ze=0,gt=0,Qt=0);let Dt=ye.convert(B.format),Mn=ye.convert(B.type),Oe;B.isData3DTexture?(qe.setTexture3D(B,0),Oe=U.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(qe.setTexture2DArray(B,0),Oe=U.TEXTURE_2D_ARRAY):(qe.setTexture2D(B,0),Oe=U.TEXTURE_2D),Me.activeTexture(U.TEXTURE0),Me.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,B.flipY),Me.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),Me.pixelStorei(U.UNPACK_ALIGNMENT,B.unpackAlignment);let pn=Me.getParameter(U.UNPACK_ROW_LENGTH),yt=Me.getParameter(U.UNPACK_IMAGE_HEIGHT),Rs=Me.getParameter(U.UNPACK_SKIP_PIXELS),mn=Me.getParameter(U.UNPACK_SKIP_ROWS),fo=Me.getParameter(U.UNPACK_SKIP_IMAGES);Me.pixelStorei(U.UNPACK_ROW_LENGTH,It.width),Me.pixelStorei(U.UNPACK_IMAGE_HEIGHT,It.height),Me.pixelStorei(U.UNPACK_SKIP_PIXELS,Ve),Me.pixelStorei(U.UNPACK_SKIP_ROWS,tt),Me.pixelStorei(U.UNPACK_SKIP_IMAGES,mt);let rs=S.isDataArrayTexture||S.isData3DTexture,Ls=B.isDataArrayTexture||B.isData3DTexture;if(S.isDepthTexture){let dt=He.get(S),rn=He.get(B),Kn=He.get(dt.__renderTarget),Nt=He.get(rn.__renderTarget);Me.bindFramebuffer(U.READ_FRAMEBUFFER,Kn.__webglFramebuffer),Me.bindFramebuffer(U.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let gn=0;gn<Le;gn++)rs&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,He.get(S).__webglTexture,K,mt+gn),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,He.get(B).__webglTexture,Ee,Qt+gn)),U.blitFramebuffer(Ve,tt,Ve+Re,tt+Ae,ze,gt,ze+Re,gt+Ae,U.DEPTH_BUFFER_BIT,U.NEAREST);Me.bindFramebuffer(U.READ_FRAMEBUFFER,null),Me.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(K!==0||S.isRenderTargetTexture||He.has(S)){let dt=He.get(S),rn=He.get(B);Me.bindFramebuffer(U.READ_FRAMEBUFFER,I),Me.bindFramebuffer(U.DRAW_FRAMEBUFFER,F);for(let Kn=0;Kn<Le;Kn++)rs?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,dt.__webglTexture,K,mt+Kn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,dt.__webglTexture,K),Ls?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,rn.__webglTexture,Ee,Qt+Kn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,rn.__webglTexture,Ee),K!==0?U.blitFramebuffer(Ve,tt,Ve+Re,tt+Ae,ze,gt,ze+Re,gt+Ae,U.COLOR_BUFFER_BIT,U.NEAREST):Ls?U.copyTexSubImage3D(Oe,Ee,ze,gt,Qt+Kn,Ve,tt,Re,Ae):U.copyTexSubImage2D(Oe,Ee,ze,gt,Ve,tt,Re,Ae);Me.bindFramebuffer(U.READ_FRAMEBUFFER,null),Me.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else Ls?S.isDataTexture||S.isData3DTexture?U.texSubImage3D(Oe,Ee,ze,gt,Qt,Re,Ae,Le,Dt,Mn,It.data):B.isCompressedArrayTexture?U.compressedTexSubImage3D(Oe,Ee,ze,gt,Qt,Re,Ae,Le,Dt,It.data):U.texSubImage3D(Oe,Ee,ze,gt,Qt,Re,Ae,Le,Dt,Mn,It):S.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,Ee,ze,gt,Re,Ae,Dt,Mn,It.data):S.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,Ee,ze,gt,It.width,It.height,Dt,It.data):U.texSubImage2D(U.TEXTURE_2D,Ee,ze,gt,Re,Ae,Dt,Mn,It);Me.pixelStorei(U.UNPACK_ROW_LENGTH,pn),Me.pixelStorei(U.UNPACK_IMAGE_HEIGHT,yt),Me.pixelStorei(U.UNPACK_SKIP_PIXELS,Rs),Me.pixelStorei(U.UNPACK_SKIP_ROWS,mn),Me.pixelStorei(U.UNPACK_SKIP_IMAGES,fo),Ee===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&U.generateMipmap(Oe),Me.unbindTexture()},this.initRenderTarget=function(S){He.get(S).__webglFramebuffer===void 0&&qe.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?qe.setTextureCube(S,0):S.isData3DTexture?qe.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?qe.setTexture2DArray(S,0):qe.setTexture2D(S,0),Me.unbindTexture()},this.resetState=function(){q=0,V=0,le=null,Me.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ai}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}};function Yp(i){let e=i.height_m/Math.tan(i.up_rad),t=i.height_m/Math.tan(i.down_rad),n=(e+i.top_m+t)/2;return[{x:-n,y:0},{x:n,y:0},{x:n-t,y:i.height_m},{x:-n+e,y:i.height_m}]}function rv(i){let e=i.depth_m/2;return[{x:-e,y:0},{x:e,y:0},{x:e,y:i.height_m},{x:-e,y:i.height_m}]}function cu(i,e,t=12){let n=[];for(let[s,r]of[[i/2,-Math.PI/2],[-i/2,Math.PI/2]])for(let o=0;o<=t;o++){let a=r+Math.PI*o/t;n.push({x:s+e*Math.cos(a),y:e+e*Math.sin(a)})}return n}function jo(i,e){return 2*i+2*Math.PI*e}function hu(i,e,t){let n=jo(i,e),s=Math.PI*e,r=(t%n+n)%n;return r<i/2?{x:r,y:0,outward_rad:-Math.PI/2}:(r-=i/2,r<s?iv(i/2,e,-Math.PI/2+r/e):(r-=s,r<i?{x:i/2-r,y:2*e,outward_rad:Math.PI/2}:(r-=i,r<s?iv(-i/2,e,Math.PI/2+r/e):{x:-i/2+r-s,y:0,outward_rad:-Math.PI/2})))}function iv(i,e,t){return{x:i+e*Math.cos(t),y:e+e*Math.sin(t),outward_rad:t}}function ov(i,e){let t=i.length,n=[],s=-e/2,r=e/2,o=(...a)=>{for(let[l,c]of a){let h=i[l%t]??{x:0,y:0};n.push(h.x,c,h.y)}};for(let a=0;a<t;a++)o([a,s],[a+1,r],[a+1,s]),o([a,s],[a,r],[a+1,r]);for(let a=1;a<t-1;a++)o([0,s],[a,s],[a+1,s]),o([0,r],[a+1,r],[a,r]);return new Float32Array(n)}function sv(i,e,t){let n=Math.cos(i.heading_rad),s=Math.sin(i.heading_rad),r=e-i.x_m,o=t-i.y_m;return{x:n*r+s*o,y:-s*r+n*o}}function Ys(i,e,t){let n=Math.cos(i.heading_rad),s=Math.sin(i.heading_rad);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([r=0,o=0])=>{let a=r*e/2,l=o*t/2;return{x:i.x_m+n*a-s*l,y:i.y_m+s*a+n*l}})}function Qo(i){return 2*(Yp(i)[1]?.x??0)}function pA(i,e,t){let n=0;for(let s of i.ramps){let r=sv(s,e,t),o=Qo(s)/2;if(Math.abs(r.y)>s.width_m/2||Math.abs(r.x)>=o)continue;let a=Math.min((r.x+o)*Math.tan(s.up_rad),(o-r.x)*Math.tan(s.down_rad));n=Math.max(n,Math.min(a,s.height_m))}for(let s of i.blocks){let r=sv(s,e,t);Math.abs(r.y)<=s.width_m/2&&Math.abs(r.x)<=s.depth_m/2&&(n=Math.max(n,s.height_m))}return n}function av(i,e=.005){let t=[];return i.path.forEach((n,s)=>{let r=i.path[s-1],o=r===void 0?1:Math.ceil(Math.hypot(n.x_m-r.x_m,n.y_m-r.y_m)/e);for(let a=1;a<=o;a++){let l=r===void 0?n.x_m:r.x_m+(n.x_m-r.x_m)*a/o,c=r===void 0?n.y_m:r.y_m+(n.y_m-r.y_m)*a/o;t.push(l,c,pA(i,l,c))}}),new Float32Array(t)}function Tl(i){let e=i?.fence;if(!e)return[];if(e.corners!==void 0)return e.corners.map(({x_m:o,y_m:a})=>({x:o,y:a}));let{min_x_m:t,max_x_m:n,min_y_m:s,max_y_m:r}=e;return[{x:t,y:s},{x:n,y:s},{x:n,y:r},{x:t,y:r}]}function uu(i){return(i?.keep_out??[]).map(({corners:e})=>e.map(({x_m:t,y_m:n})=>({x:t,y:n})))}function yr(i){let e={min_x:1/0,max_x:-1/0,min_y:1/0,max_y:-1/0},t=(n,s)=>{e.min_x=Math.min(e.min_x,n),e.max_x=Math.max(e.max_x,n),e.min_y=Math.min(e.min_y,s),e.max_y=Math.max(e.max_y,s)};for(let n of i?.path??[])t(n.x_m,n.y_m);for(let n of i?.ramps??[])for(let{x:s,y:r}of Ys(n,Qo(n),n.width_m))t(s,r);for(let n of i?.blocks??[])for(let{x:s,y:r}of Ys(n,n.depth_m,n.width_m))t(s,r);for(let{x:n,y:s}of Tl(i))t(n,s);return e.min_x>e.max_x?{min_x:-1,max_x:1,min_y:-.6,max_y:.6}:e}function lv(i,e,t,n,s,r){let o=i.length/3;for(let a=e;a<t;a++){let l=3*Math.max(a-1,0),c=3*Math.min(a+1,o-1),h=3*a,u=(i[c]??0)-(i[l]??0),d=(i[c+1]??0)-(i[l+1]??0),f=Math.hypot(u,d)||1;u*=n/2/f,d*=n/2/f;let g=i[h]??0,y=i[h+1]??0,p=(i[h+2]??0)+s;r.set([g-d,y+u,p,g+d,y-u,p],6*a)}}function Kp(i,e){let t=new Gn;return t.setAttribute("position",new Un(ov(i,e),3)),t.computeVertexNormals(),t}function Hr(i,e,t,n){let s=Kp(i,e),r=new en(s,new Xi({color:t}));return r.castShadow=!0,r.receiveShadow=!0,n!==void 0&&r.add(new Wi(new Or(s,20),new Pi({color:n}))),r}function ea([i,e,t],[n,s,r],o){let a=Hr([{x:-n/2,y:-r/2},{x:n/2,y:-r/2},{x:n/2,y:r/2},{x:-n/2,y:r/2}],s,o);return a.position.set(i,e,t),a}function El(i){i.traverse(e=>{if(!(e instanceof en||e instanceof Wi))return;e.geometry.dispose();let t=e.material;for(let n of Array.isArray(t)?t:[t])n.map?.dispose(),n.dispose()}),i.clear()}var Wr={name:"",length_m:.185,width_m:.2,height_m:.06,gauge_m:.155,axle_spacing_m:.133,wheel_radius_m:.026,shoe_width_m:.045},cv=.012,hv=["000000","011010","001110","010010","011100","000000"],Al=class{constructor(e){this.shape=e;let{axle_spacing_m:t,wheel_radius_m:n,shoe_width_m:s,gauge_m:r}=e,o=cu(t,n-.002),a=this.track(r/2,o),l=this.track(-r/2,o);this.cleats=[a,l];let c=r-s,h=e.height_m-.012;this.group.add(ea([0,0,(.016+h)/2],[t+n*.9,c-.006,h-.016],"#2b333d"),ea([0,0,h],[t+n*1.2,c+.01,.003],"#c9d1da"),ea([-.02,0,h+.004],[.075,.05,.003],"#0f7f86"),ea([-.054,.012,h+.008],[.014,.012,.01],"#aab3bd"),ea([t/2+n*.62,0,h-.008],[.006,c*.7,.006],"#fff3c4"),mA(e.height_m)),this.group.rotation.order="ZYX"}shape;group=new Ci;cleats;set(e,t,n){fv(this.group,e),this.run(this.cleats[0],t),this.run(this.cleats[1],n)}track(e,t){let{axle_spacing_m:n,wheel_radius_m:s,shoe_width_m:r}=this.shape,o=Hr(t,r,"#1b2026");o.position.y=e,this.group.add(o);for(let c of[-n/2,n/2]){let h=Hr(cu(0,s-.007,10),r+.002,"#8b96a3");h.position.set(c,e,.007),this.group.add(h)}let a=Math.round(jo(n,s)/cv),l=new el(new ur(cv*.5,r+.001,.0035),new Xi({color:"#4a545f"}),a);return l.position.y=e,l.castShadow=!0,l.frustumCulled=!1,this.group.add(l),l}run(e,t){let{axle_spacing_m:n,wheel_radius_m:s}=this.shape,r=jo(n,s);for(let o=0;o<e.count;o++){let a=hu(n,s-.002,o*r/e.count-t);uv.setFromAxisAngle(gA,Math.PI/2-a.outward_rad),dv.compose(vA.set(a.x,0,a.y+5e-4),uv,_A),e.setMatrixAt(o,dv)}e.instanceMatrix.needsUpdate=!0}},du=class{group=new Ci;constructor(e,t){let n=cu(e.axle_spacing_m,e.wheel_radius_m,6),s=Kp(n,e.shoe_width_m),r=new Or(s,40);s.dispose();for(let o of[-1,1]){let a=new Wi(r,new Pi({color:t,transparent:!0,opacity:.9}));a.position.y=o*e.gauge_m/2,this.group.add(a)}this.group.rotation.order="ZYX"}set(e){fv(this.group,e)}};function fv(i,e){i.position.set(e.x_m,e.y_m,e.z_m),i.rotation.set(e.roll_rad,e.pitch_rad,e.yaw_rad,"ZYX")}function mA(i){let e=hv.length+2,t=new Uint8Array(4*e*e).fill(255);hv.forEach((r,o)=>{for(let a=0;a<r.length;a++){let l=4*((o+1)*e+a+1);r[a]==="0"&&t.fill(16,l,l+3)}});let n=new kr(t,e,e);n.colorSpace=Qn,n.magFilter=yn,n.needsUpdate=!0;let s=new en(new ps(.05,.05),new Xi({map:n}));return s.position.set(.045,0,i),s}var gA=new $(0,1,0),_A=new $(1,1,1),vA=new $,uv=new ni,dv=new Rt;function pv(i){return/^\s*\[(model|shape|drive|emulated)\b/m.test(i)&&!/^\s*\[\[segment\]\]/m.test(i)?"robot":"course"}function fu(i){return i.replace(/\.toml$/i,"").replace(/[^A-Za-z0-9._-]+/g,"-").replace(/^[.-]+/,"").slice(0,64)}function mv(i){let e=(t,n)=>t===void 0||t===0?[]:[`${t} ${n}${t===1?"":"s"}`];return i.length_m===void 0?"":[`${i.length_m.toFixed(2)} m`,...i.duration_s===void 0?[]:[`${i.duration_s.toFixed(0)} s`],...e(i.ramps?.length,"ramp"),...e(i.blocks?.length,"block"),...e(i.surfaces?.length,"surface"),...e(i.disturbances,"disturbance")].join(" · ")}var Yv=Rw(Xv(),1),sa=class{constructor(e){this.text=e;let[t]=(0,Yv.parseTOML)(e,{tomlVersion:"1.0.0"}).body;this.take([],t.body.filter(n=>n.type==="TOMLKeyValue"),void 0);for(let n of t.body)n.type==="TOMLTable"&&this.take(n.resolvedKey,n.body,n.range)}text;pieces_=new Map;all(e){return this.pieces_.get(e)??[]}one(e){return this.pieces_.get(e)?.[0]??{table:e,index:0,values:{},ranges:{},range:void 0}}with(e,t){let n=[],s=[];for(let[r,o]of Object.entries(t)){let a=e.ranges[r];a===void 0?n.push(um(r,o)):IC(e.values[r],o)||s.push({from:a[0],to:a[1],text:Nl(o)})}return n.length>0&&s.push(this.inserted(e,n)),s.sort((r,o)=>o.from-r.from),s.reduce((r,{from:o,to:a,text:l})=>r.slice(0,o)+l+r.slice(a),this.text)}added(e,t,n=this.all(e).at(-1)){let s=$v(`[[${e}]]`,t);if(n!==void 0&&n.range===void 0)throw ku(n);let r=this.one("fence").range,o=n?.range!==void 0?this.lineEnd(n.range[1]):r===void 0?this.text.length:this.above(r[0]);return qv(this.text.slice(0,o),s,this.text.slice(o))}addedBefore(e,t,n){let s=this.all(e)[t]?.range;if(s===void 0)return this.added(e,n);let r=this.above(s[0]);return qv(this.text.slice(0,r),$v(`[[${e}]]`,n),this.text.slice(r))}replaced(e,t,n){let s=t.flatMap(a=>e.ranges[a]?.[0]??[]).map(a=>this.text.lastIndexOf(`
`,a)+1),r=Math.min(...s);if(!Number.isFinite(r)||e.range===void 0)throw ku(e);let o=this.text;for(let a of s.sort((l,c)=>c-l))o=o.slice(0,a)+o.slice(this.lineEnd(a));return o.slice(0,r)+Object.entries(n).map(([a,l])=>um(a,l)).join("")+o.slice(r)}removed(e){if(e.range===void 0)throw ku(e);let t=this.above(e.range[0]),n=this.lineEnd(e.range[1]);for(;this.text[n]===`
`||this.text.startsWith(`\r
`,n);)n+=this.text[n]===`
`?1:2;return this.text.slice(0,t)+this.text.slice(n)}take(e,t,n){let s={},r={},o=[];for(let a of t){let l=a.key.keys.map(c=>c.type==="TOMLBare"?c.name:c.value);if(a.value.type==="TOMLInlineTable")o.push([[...e,...l],a.value.body]);else if(a.value.type==="TOMLArray"&&a.value.elements[0]?.type==="TOMLInlineTable")a.value.elements.forEach((c,h)=>{c.type==="TOMLInlineTable"&&o.push([[...e,...l,h],c.body])});else{let c=Kv(a.value);if(c===void 0)continue;let[h,u]=e.length===0&&l.length===2?[l[0],l[1]]:[void 0,l.join(".")];if(u===void 0)continue;h===void 0?(s[u]=c,r[u]=a.value.range):o.push([[h],[{...a,key:{...a.key,keys:a.key.keys.slice(1)}}]])}}this.add(String(e[0]??""),s,r,n);for(let[a,l]of o)this.take(a,l,void 0)}add(e,t,n,s){let r=this.pieces_.get(e)??[];r.push({table:e,index:r.length,values:t,ranges:n,range:s}),this.pieces_.set(e,r)}inserted(e,t){if((e.table==="start"||e.table==="fence")&&Object.keys(e.values).length===0&&e.range===void 0){let a=this.above(this.all("segment")[0]?.range?.[0]??this.text.length);return{from:a,to:a,text:`[${e.table}]
${t.join("")}
`}}if(e.range===void 0&&e.table!=="")throw ku(e);let s=Math.max(e.range?.[1]??0,...Object.values(e.ranges).map(([,a])=>a)),r=s===0?0:this.lineEnd(s),o=r>0&&this.text[r-1]!==`
`?`
${t.join("")}`:t.join("");return{from:r,to:r,text:o}}above(e){let t=this.text.lastIndexOf(`
`,e-1)+1;for(;;){let n=this.text.lastIndexOf(`
`,t-2)+1;if(t===0||!/^[ \t]*#/.test(this.text.slice(n,t)))return t;t=n}}lineEnd(e){let t=this.text.indexOf(`
`,e);return t<0?this.text.length:t+1}};function qv(i,e,t){let n=i===""||/\n\s*\n$/.test(i)?"":i.endsWith(`
`)?`
`:`

`,s=t===""||/^\r?\n/.test(t)?"":`
`;return i+n+e+s+t}function ku(i){return new Error(`${i.table} is not written as a table of its own: change it in the text`)}function Kv(i){if(i.type==="TOMLArray")return i.elements.map(Kv).filter(e=>e!==void 0);if(i.type==="TOMLValue")return typeof i.value=="object"?void 0:i.value}function IC(i,e){return i!==void 0&&Nl(i)===Nl(e)}function $v(i,e){return`${i}
${Object.entries(e).map(([t,n])=>um(t,n)).join("")}`}function um(i,e){return`${i} = ${Nl(e)}
`}function Nl(i){if(Array.isArray(i))return`[${i.map(Nl).join(", ")}]`;if(typeof i!="number")return JSON.stringify(i);let e=String(Number(i.toFixed(3))+0);return e.includes(".")?e:`${e}.0`}var Li=Math.PI/180,DC=.02,NC=3*Li;function jt(i,e,t=0){let n=i.values[e];return typeof n=="number"&&Number.isFinite(n)?n:t}function kl(i){return{x:jt(i,"x_m"),y:jt(i,"y_m"),yaw_rad:jt(i,"yaw_deg")*Li,s_m:0}}function Jv(i){let e=jt(i,"angle_deg")*Li;return i.values.type==="line"?{length_m:jt(i,"length_m"),angle_rad:0}:i.values.type==="arc"?{length_m:jt(i,"radius_m")*Math.abs(e),angle_rad:e}:{length_m:0,angle_rad:e}}function $r(i,e,t=1){let{length_m:n,angle_rad:s}=Jv(e),[r,o]=[t*n,t*s],a=i.yaw_rad+o,l=i.s_m+r;if(o===0||r===0)return{x:i.x+r*Math.cos(i.yaw_rad),y:i.y+r*Math.sin(i.yaw_rad),yaw_rad:a,s_m:l};let c=r/o;return{x:i.x+c*(Math.sin(a)-Math.sin(i.yaw_rad)),y:i.y-c*(Math.cos(a)-Math.cos(i.yaw_rad)),yaw_rad:a,s_m:l}}function dm(i,e){let t=[i];for(let n of e)t.push($r(t.at(-1)??i,n));return t}function fm(i,e){let t=[Zv(i)],n=i;for(let s of e){let{length_m:r,angle_rad:o}=Jv(s),a=Math.min(Math.max(Math.ceil(r/DC),Math.ceil(Math.abs(o)/NC),1),2e3);for(let l=1;l<=a;l++)t.push(Zv($r(n,s,l/a)));n=$r(n,s)}return t}function Zv({x:i,y:e,yaw_rad:t,s_m:n}){return{x_m:i,y_m:e,yaw_rad:t,s_m:n}}function pm(i,e){let t=Math.cos(i.yaw_rad)*(e.x-i.x)+Math.sin(i.yaw_rad)*(e.y-i.y);return Math.max(t,.01)}function mm(i,e){let[t,n]=[e.x-i.x,e.y-i.y],s=Math.cos(i.yaw_rad)*t+Math.sin(i.yaw_rad)*n,r=-Math.sin(i.yaw_rad)*t+Math.cos(i.yaw_rad)*n,o=Math.hypot(s,r),a=r<0?-1:1,l=Math.min(o*o/Math.max(2*Math.abs(r),1e-6),100),c=2*Math.atan2(Math.abs(r),s)/Li;return{radius_m:Math.max(l,.01),angle_deg:a*Math.max(c,.1)}}function gm(i,e){let t,n=1/0;for(let s of i){let r=Math.hypot(s.x_m-e.x,s.y_m-e.y);r<n&&([t,n]=[s,r])}return t}function jv(i,e){return i.find(t=>t.s_m>=e-1e-9)??i.at(-1)}var Qv=.15,ty=`description = "drawn on the page"
speed_mps = 0.1

[[segment]]
type = "line"
length_m = 0.6

[fence]
min_x_m = -0.3
max_x_m = 1.6
min_y_m = -0.8
max_y_m = 0.8
`,ra={segment:{},ramp:{heading_deg:0,height_m:.05,up_deg:15,top_m:.2,down_deg:15,width_m:.4},block:{heading_deg:0,height_m:.02,depth_m:.1,width_m:.4},surface:{name:"other ground",heading_deg:0,length_m:.3,width_m:.5,friction_factor:1,slip_offset:0},disturbance:{at_m:0,sideways_m:.03,yaw_deg:0,duration_s:.3},keep_out:{}};function Ol(i,{table:e,index:t}){return e==="start"||e==="fence"||e===""?i.one(e):i.all(e)[t]}function Ou(i){return{x_m:jt(i,"x_m"),y_m:jt(i,"y_m"),heading_rad:jt(i,"heading_deg")*Li}}function Yr(i){let e=i.values.corners_m;if(!Array.isArray(e))return;let t=e.map(n=>Array.isArray(n)?{x:Number(n[0]),y:Number(n[1])}:{x:NaN,y:NaN});return t.length>0&&t.every(({x:n,y:s})=>Number.isFinite(n+s))?t:void 0}var ny=i=>i.map(({x:e,y:t})=>[e,t]);function vm(i){let e=Yr(i);if(e!==void 0)return e;let[t,n,s,r]=["min_x_m","max_x_m","min_y_m","max_y_m"].map(o=>jt(i,o,NaN));if(Number.isFinite(t+n+s+r))return[{x:t,y:s},{x:n,y:s},{x:n,y:r},{x:t,y:r}]}var ey=({x:i,y:e})=>({x_m:i,y_m:e});function ym(i,e,t){let n=kl(i.one("start")),s=fm(n,i.all("segment")),r=vm(i.one("fence")),o=(r??[]).map(({x:l})=>l),a=(r??[]).map(({y:l})=>l);return{name:e,description:"",speed_mps:jt(i.one(""),"speed_mps",.1),length_m:s.at(-1)?.s_m??0,start:{x_m:n.x,y_m:n.y,yaw_rad:n.yaw_rad},path:s,ramps:i.all("ramp").map(l=>({...Ou(l),height_m:jt(l,"height_m"),up_rad:jt(l,"up_deg",15)*Li,top_m:jt(l,"top_m"),down_rad:jt(l,"down_deg",15)*Li,width_m:jt(l,"width_m")})),blocks:i.all("block").map(l=>({...Ou(l),height_m:jt(l,"height_m"),depth_m:jt(l,"depth_m"),width_m:jt(l,"width_m")})),surfaces:i.all("surface").map(l=>({...Ou(l),name:String(l.values.name??""),length_m:jt(l,"length_m"),width_m:jt(l,"width_m")})),disturbances:[],...r===void 0?{}:{fence:{min_x_m:Math.min(...o),max_x_m:Math.max(...o),min_y_m:Math.min(...a),max_y_m:Math.max(...a),corners:r.map(ey)}},keep_out:i.all("keep_out").map(l=>({corners:(Yr(l)??[]).map(ey)})),robot:t}}function iy(i){return[...kC(i),...OC(i),...UC(i),...FC(i)]}function kC(i){let e=i.one("start"),t=kl(e),n=i.all("segment"),s=dm(t,n),r=[br("start","Start",e,t,({x:o,y:a})=>i.with(e,{x_m:o,y_m:a})),_m("start-turn","Direction of the start",e,t,t.yaw_rad,o=>i.with(e,{yaw_deg:o/Li}))];return n.forEach((o,a)=>{let l=s[a]??t,c=`segment-${a}`,h=`End of ${String(o.values.type)} ${a+1}`;if(o.values.type==="line")r.push(br(c,h,o,$r(l,o),u=>i.with(o,{length_m:pm(l,u)})));else if(o.values.type==="arc")r.push(br(c,h,o,$r(l,o),u=>i.with(o,{...mm(l,u)})));else if(o.values.type==="pivot"){let u=d=>i.with(o,{angle_deg:sy(d-l.yaw_rad)});r.push(_m(c,h,o,l,$r(l,o).yaw_rad,u))}}),r}function OC(i){return["ramp","block","surface"].flatMap(e=>i.all(e).flatMap(t=>{let{x_m:n,y_m:s,heading_rad:r}=Ou(t),o=`${e}-${t.index}`,a=`${e} ${t.index+1}`;return[br(o,a,t,{x:n,y:s},l=>i.with(t,{x_m:l.x,y_m:l.y})),_m(`${o}-turn`,`Direction of ${a}`,t,{x:n,y:s},r,l=>i.with(t,{heading_deg:l/Li}))]}))}function UC(i){let e=ry(i);return i.all("disturbance").flatMap(t=>{let n=jv(e,jt(t,"at_m"));if(n===void 0)return[];let s=r=>i.with(t,{at_m:gm(e,r)?.s_m??0});return[br(`disturbance-${t.index}`,`disturbance ${t.index+1}`,t,{x:n.x_m,y:n.y_m},s)]})}function FC(i){let e=i.one("fence"),t=[],n=(r,o,a)=>{o.forEach((l,c)=>{let h=u=>i.with(r,{corners_m:ny(o.map((d,f)=>f===c?u:d))});t.push(br(`${r.table}-${r.index}-${c}`,`Corner ${c+1} of ${a}`,r,l,h))})},s=Yr(e);if(s!==void 0)n(e,s,"the fence");else{let r=[["min_x_m","min_y_m"],["max_x_m","min_y_m"],["max_x_m","max_y_m"],["min_x_m","max_y_m"]];(vm(e)??[]).forEach((o,a)=>{let[l,c]=r[a]??r[0];t.push(br(`fence-0-${a}`,`Corner ${a+1} of the fence`,e,o,h=>i.with(e,{[l]:h.x,[c]:h.y})))})}for(let r of i.all("keep_out"))n(r,Yr(r)??[],`keep-out area ${r.index+1}`);return t}function br(i,e,t,{x:n,y:s},r){return{id:i,label:e,turns:!1,at:{x:n,y:s},piece:{table:t.table,index:t.index},drag:r}}function _m(i,e,t,n,s,r){let o={x:n.x+Qv*Math.cos(s),y:n.y+Qv*Math.sin(s)};return{...br(i,e,t,o,a=>r(Math.atan2(a.y-n.y,a.x-n.x))),turns:!0}}function sy(i){let e=i-2*Math.PI*Math.round(i/(2*Math.PI));return Math.max(Math.abs(e/Li),1)*(e<0?-1:1)}function ry(i){return fm(kl(i.one("start")),i.all("segment"))}function oy(i){let e=ay(i);return{x:e.x+.3*Math.cos(e.yaw_rad),y:e.y+.3*Math.sin(e.yaw_rad)}}function ay(i){let e=kl(i.one("start"));return dm(e,i.all("segment")).at(-1)??e}function ly(i,e,t){let n=ay(i),s=u=>({text:i.added("segment",u),piece:{table:"segment",index:i.all("segment").length}});if(e==="line")return s({type:"line",length_m:pm(n,t)});if(e==="arc")return s({type:"arc",...mm(n,t)});if(e==="pivot")return s({type:"pivot",angle_deg:sy(Math.atan2(t.y-n.y,t.x-n.x)-n.yaw_rad)});let r=i.all(e).length;if(e==="keep_out"){let u=[[-1,-1],[1,-1],[1,1],[-1,1]].map(([d=0,f=0])=>[t.x+.1*d,t.y+.1*f]);return{text:i.added("keep_out",{corners_m:u}),piece:{table:"keep_out",index:r}}}let o=gm(ry(i),t);if(e==="disturbance"){let u=o?.s_m??0,d=i.all("disturbance").filter(f=>jt(f,"at_m")<=u);return d.length<r?{text:i.addedBefore("disturbance",d.length,{...ra.disturbance,at_m:u}),piece:{table:e,index:d.length}}:{text:i.added(e,{...ra.disturbance,at_m:u}),piece:{table:e,index:r}}}let a=(o?.yaw_rad??0)/Li%360,{name:l,...c}=ra[e],h={...l===void 0?{}:{name:l},x_m:t.x,y_m:t.y,...c,heading_deg:a};return{text:i.added(e,h),piece:{table:e,index:r}}}function cy(i,e,t){let n=e.table==="fence"?vm(e):Yr(e),[s,r]=[n?.[t],n?.[(t+1)%(n.length||1)]];if(n===void 0||s===void 0||r===void 0)return i.text;let o={x:(s.x+r.x)/2,y:(s.y+r.y)/2};return uy(i,e,[...n.slice(0,t+1),o,...n.slice(t+1)])}function hy(i,e,t){let n=Yr(e);return n===void 0||n.length<=3?i.text:uy(i,e,n.filter((s,r)=>r!==t))}function uy(i,e,t){let n={corners_m:ny(t)};return Yr(e)===void 0?i.replaced(e,["min_x_m","max_x_m","min_y_m","max_y_m"],n):i.with(e,n)}var BC={...ra,"":{description:"",speed_mps:.1},start:{x_m:0,y_m:0,yaw_deg:0}},zC={"":"course",keep_out:"keep-out area"};function dy(i,e){let t=i.table in ra,n=`${zC[i.table]??i.table}${t?` ${i.index+1}`:""}`,s=A("div",{class:"draw-fields",role:"group","aria-label":n},A("h3",{},n)),r=BC[i.table]??{};for(let o of new Set([...Object.keys(i.values),...Object.keys(r)])){let a=i.values[o]??r[o];if(a===void 0||Array.isArray(a)||typeof a=="boolean"||o==="type")continue;let l=typeof a=="number",c=A("input",{type:l?"number":"text",name:o,step:"any",value:String(a)});c.addEventListener("change",()=>{let h=l?Number(c.value):c.value;c.value!==""&&(!l||Number.isFinite(h))&&e(o,h)}),s.append(A("label",{},`${o} `,c))}return s}function fy(i,e,t){return JSON.stringify([i.values,e,t?.values])}var Uu=class{texts=[""];at=0;restart(e){this.texts=[e],this.at=0}add(e){e!==this.text&&(this.texts=[...this.texts.slice(0,this.at+1),e].slice(-200),this.at=this.texts.length-1)}get text(){return this.texts[this.at]??""}get canUndo(){return this.at>0}get canRedo(){return this.at+1<this.texts.length}undo(){return this.canUndo&&this.at--,this.text}redo(){return this.canRedo&&this.at++,this.text}};var xm=.2,py=1.2,VC=200;function my(i){let e=yr(i),t=Math.max(0,py-(e.max_x-e.min_x))/2+xm,n=Math.max(0,py-(e.max_y-e.min_y))/2+xm;return{min_x:e.min_x-t,max_x:e.max_x+t,min_y:e.min_y-n,max_y:e.max_y+n}}function gy(i,e){let[t,n]=[(i.min_x+i.max_x)/2,(i.min_y+i.max_y)/2],[s,r]=[e*(i.max_x-i.min_x)/2,e*(i.max_y-i.min_y)/2];return Math.max(s,r)>VC/2||Math.min(s,r)<xm?i:{min_x:t-s,max_x:t+s,min_y:n-r,max_y:n+r}}var _y=18,GC=.01,HC=.1,bm="http://www.w3.org/2000/svg",WC={ArrowLeft:{x:-1,y:0},ArrowRight:{x:1,y:0},ArrowUp:{x:0,y:1},ArrowDown:{x:0,y:-1}},Fu=class{constructor(e,t,n){this.pixel=e;this.world=t;this.actions=n;this.element.classList.add("draw-stage"),this.element.setAttribute("role","group"),this.element.setAttribute("aria-label","Points of the course"),this.element.style.display="none",this.element.addEventListener("pointerdown",s=>{this.down(s)}),this.element.addEventListener("pointermove",s=>{this.drag(s,!1)});for(let s of["pointerup","pointercancel"])this.element.addEventListener(s,r=>{this.drag(r,!0)});this.element.addEventListener("wheel",s=>{s.preventDefault(),n.zoom(s.deltaY>0?1.1:1/1.1)},{passive:!1})}pixel;world;actions;element=document.createElementNS(bm,"svg");knobs=new Map;handles=[];dragged;show(e){this.element.style.display=e?"":"none",this.dragged=void 0}get dragging(){return this.dragged!==void 0}draw(e,t){this.handles=e;let n=new Set(this.knobs.keys());for(let s of e){n.delete(s.id);let r=this.knobs.get(s.id)??this.make(s),o=this.pixel(s.at);r.style.display=o===void 0?"none":"",o!==void 0&&Ke(r,"transform",`translate(${o.x.toFixed(1)} ${o.y.toFixed(1)})`),Ke(r,"aria-label",`${s.label}: x ${s.at.x.toFixed(2)} m, y ${s.at.y.toFixed(2)} m`),Ke(r,"data-of",s.piece.table),St(r,"turns",s.turns),St(r,"selected",s.piece.table===t?.table&&s.piece.index===t.index)}for(let s of n)this.knobs.get(s)?.remove(),this.knobs.delete(s)}focus(e){this.knobs.get(e)?.focus()}make(e){let{id:t}=e,n=document.createElementNS(bm,"g");n.classList.add("knob"),n.dataset.handle=t,Ke(n,"tabindex","0"),Ke(n,"role","button");for(let[s,r]of[[_y,"knob-reach"],[6,"knob-dot"]]){let o=document.createElementNS(bm,"circle");o.setAttribute("r",String(s)),o.classList.add(r),n.append(o)}return n.addEventListener("focus",()=>{let s=this.handle(t);s!==void 0&&this.actions.select(s)}),n.addEventListener("keydown",s=>{this.key(s,t)}),this.knobs.set(t,n),this.element.append(n),n}handle(e){return this.handles.find(t=>t.id===e)}key(e,t){let n=this.handle(t),s=WC[e.key];if(!(n===void 0||e.ctrlKey||e.altKey||e.metaKey)){if(s!==void 0){let r=e.shiftKey?HC:GC;this.actions.move(n,{x:n.at.x+r*s.x,y:n.at.y+r*s.y},!0)}else if(e.key==="Delete"||e.key==="Backspace")this.actions.remove(n);else return;e.preventDefault()}}at(e){let t=this.element.getBoundingClientRect();return this.world({x:e.clientX-t.left,y:e.clientY-t.top})}down(e){if(!e.isPrimary||e.button!==0)return;e.preventDefault();let t=this.nearest(e);if(t===void 0){let n=this.at(e);n!==void 0&&this.actions.press(n);return}this.element.setPointerCapture(e.pointerId),this.dragged={id:t,pointer:e.pointerId},this.focus(t)}nearest(e){let t=this.element.getBoundingClientRect(),[n,s]=[void 0,_y];for(let{id:r,at:o}of this.handles){let a=this.pixel(o);if(a===void 0)continue;let l=Math.hypot(a.x-e.clientX+t.left,a.y-e.clientY+t.top);l<s&&([n,s]=[r,l])}return n}drag(e,t){if(e.pointerId!==this.dragged?.pointer)return;let n=this.handle(this.dragged.id),s=this.at(e);t&&(this.dragged=void 0),n!==void 0&&s!==void 0&&this.actions.move(n,s,t)}};var XC=150,qC=[["line","Line"],["arc","Arc"],["pivot","Turn"],["ramp","Ramp"],["block","Block"],["surface","Surface"],["disturbance","Push"],["keep_out","Keep-out"]],Bu=class{constructor(e,t,n,s){this.map=e;this.ask=t;this.robot=n;this.opens=s;this.stage=new Fu(r=>e.pixel(r),r=>e.world(r),{select:r=>{this.select(r)},move:(r,o,a)=>{this.edit(()=>r.drag(vy(o)),a)},press:r=>{this.press(r)},remove:r=>{this.select(r),this.remove()},zoom:r=>{this.zoom(r)}}),this.build()}map;ask;robot;opens;element=A("div",{class:"draw",hidden:""});stage;name=A("input",{type:"text",name:"course-name","aria-label":"Name of the course",maxlength:"64"});text=A("textarea",{rows:"14",spellcheck:"false","aria-label":"Text of the course file"});verdict=A("p",{class:"draw-verdict",role:"status"});fieldsBox=A("div");replaceButton=xs("draw-replace","Replace it");undoButton=xs("draw-undo","Undo");redoButton=xs("draw-redo","Redo");deleteButton=xs("draw-delete","Delete");cornerButton=xs("draw-corner","Add corner");closeButton=xs("draw-close","Close");saves=[xs("draw-save","Save"),xs("draw-use","Save and choose")];tools=new Map;history=new Uu;course=new sa("");handles_=[];selected;corner;tool;frame;changed=!1;opened="";saved="";shownFields="";checkAt_ms=1/0;checking=!1;chooses=!1;get active(){return!this.element.hidden}open(e,t,n){this.opened=n?e:"",this.saved=t,this.name.value=e,this.element.hidden=!1,this.selected=this.corner=void 0,this.pick(void 0),this.say(""),this.history.restart(t),this.course=new sa(""),this.take(t),this.fit(),this.stage.show(!0),this.opens(!0)}openNew(e){let t=1;for(;e.includes(`drawn-${t}`);)t++;this.open(`drawn-${t}`,ty,!1),this.pick("line")}close(){this.element.hidden=!0,this.checkAt_ms=1/0,this.stage.show(!1),this.map.draft(void 0,void 0),this.opens(!1)}tick(e,t){if(!this.active)return;this.changed&&(this.changed=!1,this.map.draft(ym(this.course,this.name.value,this.robot()??Wr),this.frame)),this.stage.draw(this.handles_,this.selected),this.undoButton.disabled=!this.history.canUndo,this.redoButton.disabled=!this.history.canRedo;let n=this.selected&&Ol(this.course,this.selected);this.deleteButton.disabled=n===void 0||["start","fence",""].includes(n.table)&&this.corner===void 0,this.cornerButton.disabled=this.corner===void 0;for(let r of this.saves)r.disabled=!t;this.replaceButton.disabled=!t;let s=fy(this.course.one(""),this.selected,n);s!==this.shownFields&&!this.stage.dragging&&!this.fieldsBox.contains(document.activeElement)&&(this.shownFields=s,this.fieldsBox.replaceChildren(...[this.course.one(""),n].filter(r=>r!==void 0).map(r=>this.fieldsOf(r)))),e>=this.checkAt_ms&&!this.checking&&this.check()}build(){let e=A("div",{class:"draw-bar",role:"toolbar","aria-label":"Draw"});for(let[n,s]of qC){let r=xs(`draw-${n}`,s);Ke(r,"aria-pressed","false"),r.addEventListener("click",o=>{o.detail===0?this.add(n,oy(this.course)):this.pick(this.tool===n?void 0:n)}),this.tools.set(n,r),e.append(r)}let t=xs("draw-fit","Fit");e.append(this.cornerButton,this.deleteButton,this.undoButton,this.redoButton,t),t.addEventListener("click",()=>{this.fit()}),this.undoButton.addEventListener("click",()=>{this.take(this.history.undo())}),this.redoButton.addEventListener("click",()=>{this.take(this.history.redo())}),this.deleteButton.addEventListener("click",()=>{this.remove()}),this.cornerButton.addEventListener("click",()=>{let n=this.selected&&Ol(this.course,this.selected),s=this.corner;n!==void 0&&s!==void 0&&this.edit(()=>cy(this.course,n,s),!0)}),this.saves.forEach((n,s)=>{n.addEventListener("click",()=>{this.chooses=s===1,this.save(!1)})}),this.replaceButton.addEventListener("click",()=>{this.save(!0)}),this.closeButton.addEventListener("click",()=>{(this.course.text!==this.saved||this.text.value!==this.course.text)&&this.closeButton.textContent==="Close"?Ne(this.closeButton,"Discard the changes"):this.close()}),this.closeButton.addEventListener("blur",()=>{Ne(this.closeButton,"Close")}),this.text.addEventListener("input",()=>{this.take(this.text.value,!1)}),this.text.addEventListener("change",()=>{this.history.add(this.text.value)}),this.element.addEventListener("keydown",n=>{this.key(n)}),this.stage.element.addEventListener("keydown",n=>{this.key(n)}),this.element.append(e,A("div",{class:"draw-answer"},this.verdict,this.replaceButton),A("div",{class:"draw-file"},A("label",{},"name ",this.name),...this.saves,this.closeButton),this.fieldsBox,A("details",{},A("summary",{},"Text of the file"),this.text))}key(e){if(!(e.ctrlKey||e.metaKey)||e.target===this.text)return;let t=e.key.toLowerCase();t!=="z"&&t!=="y"||(e.preventDefault(),this.take(t==="y"||e.shiftKey?this.history.redo():this.history.undo()))}pick(e){this.tool=e;for(let[t,n]of this.tools)Ke(n,"aria-pressed",String(t===e));St(this.stage.element,"adds",e!==void 0)}press(e){this.tool!==void 0&&(this.add(this.tool,e),this.tool!=="line"&&this.tool!=="arc"&&this.pick(void 0))}add(e,t){this.edit(()=>{let n=ly(this.course,e,vy(t));return this.selected=n.piece,this.corner=void 0,n.text},!0)}select(e){this.selected=e.piece;let t=/^(fence|keep_out)-\d+-(\d+)$/.exec(e.id);this.corner=t===null?void 0:Number(t[2])}remove(){let e=this.selected&&Ol(this.course,this.selected),t=this.corner;e!==void 0&&(this.edit(()=>{let n=t===void 0?this.course.text:hy(this.course,e,t);return n!==this.course.text||["start","fence",""].includes(e.table)?n:this.course.removed(e)},!0),this.corner=void 0)}edit(e,t){try{this.take(e()),t&&this.history.add(this.course.text)}catch(n){this.say(n instanceof Error?n.message:String(n),!0)}}take(e,t=!0){t&&this.text.value!==e&&(this.text.value=e),this.checkAt_ms=performance.now()+XC;try{this.course=new sa(e)}catch{return}this.handles_=iy(this.course),this.changed=!0,this.active&&this.stage.draw(this.handles_,this.selected)}fit(){this.frame=my(ym(this.course,"",Wr)),this.changed=!0}zoom(e){this.frame!==void 0&&(this.frame=gy(this.frame,e)),this.changed=!0}fieldsOf(e){let t={table:e.table,index:e.index};return dy(e,(n,s)=>{let r=Ol(this.course,t);r!==void 0&&this.edit(()=>this.course.with(r,{[n]:s}),!0)})}async check(){this.checking=!0,this.checkAt_ms=1/0;try{let e=await this.ask({name:"file_check",request:{kind:"course",name:fu(this.name.value)||"course",text:this.text.value}}),t=e.line===void 0?"":`line ${e.line}, column ${e.column??1}: `,n=`${e.length_m?.toFixed(2)??""} m, about ${e.duration_s?.toFixed(0)??"?"} s`;e.error!==""?this.say(t+e.error,!0):e.why_not!==""?this.say(`${e.length_m?.toFixed(2)??""} m; ${e.why_not}`,!0):this.say(n)}catch(e){this.say(e instanceof Error?e.message:String(e),!0)}finally{this.checking=!1}}async save(e){let t=this.name.value,n=this.text.value;try{if(await this.ask({name:"file_save",request:{kind:"course",name:t,text:n,replace:e||t===this.opened}}),this.opened=t,this.saved=n,this.say(`${t} is saved.`),!this.chooses)return;await this.ask({name:"choose",request:{course:t}}),this.close()}catch(s){let r=s instanceof Error?s.message:String(s);this.say(r,!0),this.replaceButton.hidden=!r.includes("exists already")}}say(e,t=!1){this.replaceButton.hidden=!0,Ne(this.verdict,e),St(this.verdict,"bad",t)}},vy=({x:i,y:e})=>({x:Math.round(i*1e3)/1e3,y:Math.round(e*1e3)/1e3});function xs(i,e){return A("button",{type:"button",id:i,class:"control"},e)}var zu=class{constructor(e,t,n,s){this.call=e;this.inputs=t;this.attended=n;this.ended=s}call;inputs;attended;ended;share=.5;limits={speed_mps:.2,yaw_rate_radps:1};wish;token;taking=!1;wasDriven=!1;unanswered=0;get drives(){return this.token!==void 0}async take(){if(!(this.drives||this.taking)){this.taking=!0,this.inputs.clear();try{let e=await this.call("drive_take",{});if(typeof e?.token!="string")throw new Error("the daemon gave no token");this.token=e.token,this.wasDriven=!1,this.unanswered=0}catch(e){this.ended(e instanceof Error?e.message:String(e))}finally{this.taking=!1}}}release(){let e=this.token;e!==void 0&&(this.forget(),this.call("drive_release",{token:e}).catch(()=>{}),this.ended(""))}lose(e){this.drives&&(this.forget(),this.ended(e))}leave(){this.inputs.clear(),this.drives&&this.send(this.inputs.wish())}received(e){this.drives&&(e.run==="driving"?this.wasDriven=!0:this.wasDriven&&this.lose(e.run==="idle"?"the robot was disarmed":`the drive is over: ${e.run}`))}tick(){!this.drives||!this.attended()||this.send(this.inputs.wish())}send(e){let t=this.token;if(this.wish=e,this.unanswered>=5)return;++this.unanswered;let n={token:t,speed_mps:e.forward*this.share*this.limits.speed_mps,yaw_rate_radps:e.left*this.share*this.limits.yaw_rate_radps,input_ms:e.at_ms};this.call("drive",n).then(()=>{this.unanswered=Math.max(0,this.unanswered-1)},s=>{t===this.token&&this.lose(s instanceof Error?s.message:String(s))})}forget(){this.token=void 0,this.wish=void 0,this.inputs.clear()}};var Sm={ArrowUp:{forward:1,left:0},KeyW:{forward:1,left:0},ArrowDown:{forward:-1,left:0},KeyS:{forward:-1,left:0},ArrowLeft:{forward:0,left:1},KeyA:{forward:0,left:1},ArrowRight:{forward:0,left:-1},KeyD:{forward:0,left:-1}},$C=150,wm=.12,YC=.9;function KC(i){return i in Sm}function Vu(i){return Math.max(-1,Math.min(1,i))}function yy(i){let e=Math.abs(i);return e>wm?Math.sign(i)*Math.min(1,(e-wm)/(YC-wm)):0}var Gu=class{constructor(e,t){this.pads=e;this.now=t}pads;now;frozen=!1;held=new Set;stick;padValues="";padChanged_ms=-1/0;key(e,t){return KC(e)?(t?this.held.add(e):this.held.delete(e),!0):!1}touch(e){this.stick=e}clear(){this.held.clear(),this.stick=void 0,this.frozen=!1,this.padChanged_ms=-1/0}wish(){let e=this.now(),t=this.pad(e);if(this.stick!==void 0)return{forward:Vu(this.stick.forward),left:Vu(this.stick.left),source:"stick",at_ms:e};if(this.held.size>0){let n=0,s=0;for(let r of this.held)n+=Sm[r]?.forward??0,s+=Sm[r]?.left??0;return{forward:Vu(n),left:Vu(s),source:"keys",at_ms:e}}return t??{forward:0,left:0,source:"none",at_ms:e}}pad(e){let t=this.pads().find(o=>o?.connected===!0&&o.axes.length>=2),n=t?`${String(t.timestamp)} ${t.axes.join(" ")}`:"";if(n!==this.padValues&&this.padValues!==""&&(this.padChanged_ms=e),this.padValues=n,this.frozen=!1,!t)return;let s=yy(-(t.axes[1]??0)),r=yy(-(t.axes[0]??0));if(!(s===0&&r===0))return this.frozen=e-this.padChanged_ms>$C,this.frozen?{forward:0,left:0,source:"gamepad",at_ms:e}:{forward:s,left:r,source:"gamepad",at_ms:this.padChanged_ms}}};var by=["foxglove.sdk.v1","foxglove.websocket.v1"],Tm=i=>typeof i=="object"&&i!==null&&!Array.isArray(i),Hu=i=>Number.isSafeInteger(i)&&i>=0,Zi=i=>typeof i=="string"?i:"",Mm=i=>Array.isArray(i)?i.filter(Tm):[],xy=i=>Array.isArray(i)?i.filter(Hu):[];function wy(i){let e;try{e=JSON.parse(i)}catch{return}if(Tm(e))switch(e.op){case"serverInfo":return{op:"serverInfo",name:Zi(e.name),sessionId:Zi(e.sessionId),capabilities:Array.isArray(e.capabilities)?e.capabilities.map(Zi):[],metadata:Tm(e.metadata)?Object.fromEntries(Object.entries(e.metadata).map(([t,n])=>[t,Zi(n)])):{}};case"advertise":return{op:"advertise",channels:Mm(e.channels).filter(t=>Hu(t.id)).map(t=>({id:t.id,topic:Zi(t.topic),encoding:Zi(t.encoding),schemaName:Zi(t.schemaName)}))};case"unadvertise":return{op:"unadvertise",channelIds:xy(e.channelIds)};case"advertiseServices":return{op:"advertiseServices",services:Mm(e.services).filter(t=>Hu(t.id)).map(t=>({id:t.id,name:Zi(t.name)}))};case"unadvertiseServices":return{op:"unadvertiseServices",serviceIds:xy(e.serviceIds)};case"parameterValues":return{op:"parameterValues",parameters:Mm(e.parameters).filter(t=>typeof t.name=="string").map(t=>({name:Zi(t.name),value:t.value})),id:typeof e.id=="string"?e.id:void 0};case"serviceCallFailure":return Hu(e.callId)?{op:"serviceCallFailure",callId:e.callId,message:Zi(e.message)}:void 0;case"status":return{op:"status",level:Number(e.level)||0,message:Zi(e.message)};default:return}}function Sy(i){let e=new DataView(i);if(!(e.byteLength<1))switch(e.getUint8(0)){case 1:return e.byteLength<13?void 0:{op:"message",subscriptionId:e.getUint32(1,!0),time_s:Number(e.getBigUint64(5,!0))*1e-9,payload:new Uint8Array(i,13)};case 2:return e.byteLength<9?void 0:{op:"time",time_s:Number(e.getBigUint64(1,!0))*1e-9};case 3:{if(e.byteLength<13)return;let t=e.getUint32(9,!0);return t>e.byteLength-13?void 0:{op:"serviceResponse",serviceId:e.getUint32(1,!0),callId:e.getUint32(5,!0),encoding:new TextDecoder().decode(new Uint8Array(i,13,t)),payload:new Uint8Array(i,13+t)}}default:return}}function My(i){return JSON.stringify({op:"subscribe",subscriptions:i})}function Ty(i){return JSON.stringify({op:"unsubscribe",subscriptionIds:i})}function Ey(i,e,t){return JSON.stringify({op:"setParameters",parameters:[{name:i,value:e}],id:t})}function Ay(i,e,t){let n=new TextEncoder().encode("json"),s=new TextEncoder().encode(JSON.stringify(t)),r=new ArrayBuffer(13+n.length+s.length),o=new DataView(r);return o.setUint8(0,2),o.setUint32(1,i,!0),o.setUint32(5,e,!0),o.setUint32(9,n.length,!0),new Uint8Array(r,13).set(n),new Uint8Array(r,13+n.length).set(s),r}var Wu=class{constructor(e,t,n=()=>performance.now()){this.make=e;this.events=t;this.now=n;this.watched_ms=this.now(),setInterval(()=>{this.watch()},500),this.open()}make;events;now;socket;isOpen=!1;silent_ms=0;watched_ms=0;retry_ms=200;retryTimer;get connected(){return this.isOpen}send(e){return!this.isOpen||this.socket===void 0?!1:(this.socket.send(e),!0)}retryNow(){this.retryTimer!==void 0&&(clearTimeout(this.retryTimer),this.open())}open(){this.retryTimer=void 0;let e=this.make();this.socket=e,this.silent_ms=0,e.onopen=()=>{this.isOpen=!0,this.silent_ms=0,this.retry_ms=200,this.events.opened()},e.onmessage=t=>{let n=t.data;this.silent_ms=0,typeof n=="string"?this.events.text(n):n instanceof ArrayBuffer&&this.events.binary(n)},e.onclose=()=>{this.drop()}}watch(){let e=this.now();this.silent_ms+=Math.min(e-this.watched_ms,500),this.watched_ms=e,this.socket!==void 0&&this.silent_ms>(this.isOpen?3e3:1e4)&&this.drop()}drop(){let e=this.socket;if(e===void 0)return;e.onopen=e.onclose=e.onmessage=null,e.close(),this.socket=void 0,this.isOpen=!1;let t=this.retry_ms;this.retry_ms=Math.min(2*t,2e3),this.events.closed(t),this.retryTimer=setTimeout(()=>{this.open()},t)}};var Xu=class{constructor(e,t,n){this.events=t;this.connection=new Wu(e,{opened:()=>{},closed:s=>{this.forget(),t.closed(s)},text:s=>{this.text(s)},binary:s=>{this.binary(s)}},n)}events;connection;listeners=new Map;channels=new Map;services=new Map;subscriptions=new Map;subscribed=new Map;calls=new Map;decoder=new TextDecoder;isReady=!1;nextSubscription=1;nextCall=1;get ready(){return this.isReady&&this.connection.connected}subscribe(e,t){this.listeners.set(e,t),this.subscribeNow([e])}unsubscribe(e){this.listeners.delete(e);let t=this.subscribed.get(e);t!==void 0&&(this.subscribed.delete(e),this.subscriptions.delete(t),this.connection.send(Ty([t])))}call(e,t={}){let n=this.services.get(e);if(!this.ready)return Promise.reject(new Error("not connected"));if(n===void 0)return Promise.reject(new Error(`the server has no service "${e}"`));let s=this.nextCall++;return new Promise((r,o)=>{this.calls.set(s,{resolve:r,reject:o}),this.connection.send(Ay(n,s,t))})}setParameter(e,t){return this.connection.send(Ey(e,t,`set ${e}`))}retryNow(){this.connection.retryNow()}text(e){let t=wy(e);switch(t?.op){case"serverInfo":this.events.serverInfo({sessionId:t.sessionId,metadata:t.metadata});break;case"advertise":for(let{id:n,topic:s}of t.channels)this.channels.set(s,n);this.isReady&&this.subscribeNow([...this.listeners.keys()]);break;case"unadvertise":for(let[n,s]of[...this.channels])t.channelIds.includes(s)&&this.channels.delete(n);break;case"advertiseServices":for(let{id:n,name:s}of t.services)this.services.set(s,n);if(this.isReady)break;this.isReady=!0,this.events.ready(),this.subscribeNow([...this.listeners.keys()]);break;case"unadvertiseServices":for(let[n,s]of[...this.services])t.serviceIds.includes(s)&&this.services.delete(n);break;case"parameterValues":this.events.parameters(t.parameters);break;case"serviceCallFailure":this.settle(t.callId)?.reject(new Error(t.message));break;case"status":this.events.status(t.level,t.message);break;case void 0:break}}binary(e){let t=Sy(e);if(t?.op==="message"){let n=this.subscriptions.get(t.subscriptionId);if(n===void 0)return;let s=this.json(t.payload);s!==void 0&&n(s,t.time_s)}else t?.op==="serviceResponse"&&this.settle(t.callId)?.resolve(this.json(t.payload))}json(e){try{return JSON.parse(this.decoder.decode(e))}catch{return}}subscribeNow(e){if(!this.ready)return;let t=[];for(let n of e){let s=this.channels.get(n),r=this.listeners.get(n);if(s===void 0||r===void 0||this.subscribed.has(n))continue;let o=this.nextSubscription++;this.subscriptions.set(o,r),this.subscribed.set(n,o),t.push({id:o,channelId:s})}t.length>0&&this.connection.send(My(t))}settle(e){let t=this.calls.get(e);return this.calls.delete(e),t}forget(){this.isReady=!1,this.channels.clear(),this.services.clear(),this.subscriptions.clear(),this.subscribed.clear();let e=[...this.calls.values()];this.calls.clear();for(let t of e)t.reject(new Error("connection lost"))}};var Cy="tp100.alerts";var qu=class{constructor(e,t,n=()=>performance.now()){this.outlets=e;this.storage=t;this.now=n;let s=(t.getItem(Cy)??"").split(" ");this.notifies_=s.includes("notify"),this.sounds_=s.includes("sound")}outlets;storage;now;notifies_=!1;sounds_=!1;wasLow=!1;quietUntil_ms=-1/0;get notifies(){return this.notifies_}set notifies(e){this.notifies_=e,this.remember()}get sounds(){return this.sounds_}set sounds(e){this.sounds_=e,this.remember()}received(e,t,n){e==="/event"&&this.event(t,n.get("/state")?.t_s),e==="/state"&&(n.battery.low&&!this.wasLow&&this.raise("the battery is low",`${n.get("/state")?.battery_v?.toFixed(2)??""} V`),this.wasLow=n.battery.low)}event(e,t){e.level!=="error"||t===void 0||e.t_s<t-1||this.raise(e.text,[e.cause,e.fix].filter(n=>n!=="").join(": "))}raise(e,t){let n=this.now();n<this.quietUntil_ms||(this.quietUntil_ms=n+3e3,this.notifies_&&this.outlets.notify(e,t),this.sounds_&&this.outlets.beep())}remember(){this.storage.setItem(Cy,[this.notifies_?"notify":"",this.sounds_?"sound":""].filter(Boolean).join(" "))}};var JC=[880,660],Py=.22,Em=class{audio;notify(e,t){if(!(!("Notification"in window)||Notification.permission!=="granted"))try{new Notification(`TP100: ${e}`,{body:t,tag:"tp100"})}catch{}}beep(){this.audio??=new AudioContext;let e=this.audio;e.resume(),JC.forEach((t,n)=>{let s=e.createOscillator(),r=e.createGain();s.frequency.value=t,r.gain.value=.2,s.connect(r).connect(e.destination),s.start(e.currentTime+n*Py),s.stop(e.currentTime+(n+1)*Py)})}},$u=class{alerts;elements;constructor(e){let t=new Em;this.alerts=new qu(t,localStorage);let n=Ry("alert-sound","sound",this.alerts.sounds);n.input.addEventListener("change",()=>{this.alerts.sounds=n.input.checked,n.input.checked&&t.beep()});let s=Ry("alert-notify","notify",this.alerts.notifies&&"Notification"in window);s.input.disabled=!("Notification"in window),s.input.disabled&&(s.element.title="This browser has no notifications for a page that is not encrypted"),s.input.addEventListener("change",()=>{this.alerts.notifies=s.input.checked,s.input.checked&&Notification.requestPermission().then(r=>{r!=="granted"&&(s.input.checked=this.alerts.notifies=!1,e("The browser does not permit notifications of this page; change it in its settings"))})}),this.elements=[A("span",{},"on faults:"),s.element,n.element]}};function Ry(i,e,t){let n=A("input",{type:"checkbox",id:i,"aria-label":`On faults: ${e}`});return n.checked=t,{element:A("label",{},n,e),input:n}}var wr=i=>i!=null&&Number.isFinite(i);function at(i,e){if(!wr(i))return"–";let t=Math.abs(i).toFixed(e);return i<0&&Number(t)!==0?"−"+t:t}function bs(i,e){return at(wr(i)?i*180/Math.PI:null,e)}function Ly(i,e){return at(wr(i)?i*1e3:null,e)}function Am(i,e){return at(wr(i)?i*100:null,e)}function qt(i){return wr(i)?i>0&&i<.95?`${i.toFixed(1)} µs`:i<1e3?`${i.toFixed(0)} µs`:i<1e4?`${(i/1e3).toFixed(1)} ms`:i<1e6?`${(i/1e3).toFixed(0)} ms`:`${(i/1e6).toFixed(1)} s`:"–"}function Ii(i){if(!wr(i)||i<0)return"–";let e=Math.floor(i*10+1e-6),t=Math.floor(e/10),n=s=>String(s).padStart(2,"0");return t>=3600?`${Math.floor(t/3600)}:${n(Math.floor(t/60)%60)}:${n(t%60)}`:`${Math.floor(t/60)}:${n(t%60)}.${e%10}`}function Iy(i){return new Date(1e3*i).toTimeString().slice(0,8)}function Di(i){if(!wr(i))return"–";let e=["B","kB","MB","GB"],t=0,n=i;for(;n>=1e3&&t<e.length-1;)n/=1e3,t++;return`${n.toFixed(t===0||n>=100?0:1)} ${e[t]??""}`}function Bn(i){return wr(i)?Math.round(i).toString().replace(/\B(?=(\d{3})+$)/g," "):"–"}var Yu=class{element=A("div",{class:"question",role:"dialog","aria-labelledby":"question-text",hidden:""});text=A("p",{id:"question-text"});first;constructor(e){let t=(n,s,r)=>{let o=A("button",{type:"button",class:"control",id:n},s);return o.addEventListener("click",()=>{this.close(),r()}),o};this.first=t("start-cancel","Cancel",()=>{}),this.element.append(this.text,this.first,t("start-placed","Placed back at the start: start there",()=>{e("start")}),t("start-here","Go on from here",()=>{e("here")}))}get open(){return!this.element.hidden}ask(e){this.element.hidden=!1,this.show(e,!0),this.first.focus()}close(){this.element.hidden=!0}show(e,t){if(!this.open)return;let n=e?.go_on_from;if(n===void 0||!t){this.close();return}let s=`x ${at(n.x_m,2)} m, y ${at(n.y_m,2)} m, yaw ${bs(n.yaw_rad,0)}°`,r=`${at(e?.progress_m,2)} of ${at(e?.length_m,2)} m along the course`;Ne(this.text,`The last run ended on its way. The robot is believed to be at ${s}, ${r}. Where is it now?`)}};var jC=3e3,QC="This daemon takes no commands from here but STOP (server.commands)",Zu=class{constructor(e,t,n=()=>performance.now()){this.send=e;this.sendStart=t;this.now=n;this.question=new Yu(this.sendStart),this.element.append(this.start.button,this.pause.button,this.hold.button,this.record.button,this.question.element),this.start.button.addEventListener("click",()=>{this.pressStart()}),this.pause.button.addEventListener("click",()=>{this.pressPause()}),this.hold.button.addEventListener("click",()=>{this.pressHold()}),this.record.button.addEventListener("click",()=>{this.send(this.recording?"record_stop":"record_start")})}send;sendStart;now;element=A("div",{class:"controls",role:"group","aria-label":"Run"});start=Ku("start","play","Start","r");pause=Ku("pause","pause","Pause","p");hold=Ku("hold","square","Hold","h");record=Ku("record","record","Record","");question;confirmUntil_ms=0;state;needsConfirmation=!0;recording=!1;pressStart(){if(this.start.button.disabled||this.question.open)return;if(this.state?.go_on_from!==void 0){this.question.ask(this.state);return}let e=this.now();if(this.needsConfirmation&&e>this.confirmUntil_ms){this.confirmUntil_ms=e+jC;return}this.confirmUntil_ms=0,this.sendStart("start")}pressPause(){this.pause.button.disabled||this.send(this.state?.pause_left_s===void 0?"pause":"resume")}pressHold(){this.hold.button.disabled||this.send("hold")}forget(){this.question.close(),this.confirmUntil_ms=0}show(e,t,n){let s=e.get("/state"),r=t&&n&&s!==void 0&&!e.stale("/state");this.needsConfirmation=s?.confirm_start!==!1;let o=this.now()<this.confirmUntil_ms,a=r&&s.can.start;this.start.button.disabled=!a,this.state=s,this.question.show(s,a),St(this.start.button,"confirm",o),Ne(this.start.label,o?"Press again":"Start");let l=n?s?.why_not_start??"":QC;Ke(this.start.button,"title",l===""?"Start the course (r)":l);let c=s?.pause_left_s,h=s?.can.pause===!0||s?.can.resume===!0;this.start.button.hidden=h,this.pause.button.hidden=!h,this.pause.button.disabled=!(r&&h),St(this.pause.button,"confirm",c!==void 0),Ne(this.pause.label,c===void 0?"Pause":"Resume"),Ke(this.pause.button,"title",c===void 0?"Stand still on the path, armed (p)":`Go on (p); the run ends in ${c.toFixed(0)} s`),this.hold.button.disabled=!(r&&s.can.hold);let u=e.get("/recording");this.recording=u?.active===!0,this.record.button.disabled=!(r&&(s.can.record||this.recording)),St(this.record.button,"active",this.recording),Ne(this.record.label,this.recording?Ii(u?.elapsed_s):"Record");let d=u?.available===!1?"No directory to record to: start tp100d with --record DIR":"",f=this.recording?`${u?.run??""}, ${Di(u?.bytes)}`:d;Ke(this.record.button,"title",u?.warning===""||u===void 0?f:u.warning),St(this.record.button,"warn",(u?.warning??"")!=="")}};function Ku(i,e,t,n){let s=A("span",{class:"button-label"},t),r=A("button",{type:"button",id:i,class:"control"},hs(e),s);return n!==""&&r.setAttribute("aria-keyshortcuts",n),{button:r,label:s}}var Ji="#f2f5f8",Ni={model:"#ff5b52",odometry:"#4d9fff",fused:"#3ad07c",truth:"#ffd23f"},Ul="#58b7e8",Fl="#f0a35e";var Cm="#0b1016",Ju="#0b131d",ju="#212d3b",Qu="#34465a",ed="#4a5868",Dy="#3a1d26",Sr="#6b7785",Bl="#aeb9c6",oa="#37506b";var aa="#7f8c9b";var td=.12;function Ny(i,e){let t=A("button",{type:"button",class:"control card-choose"},i.in_force?"In use":"Choose");t.dataset.fixed=String(i.in_force||i.why_not!==""),t.setAttribute("aria-label",`Choose course ${i.name}`),t.addEventListener("click",()=>{e.choose(i)});let n=A("button",{type:"button",class:"link card-edit","aria-label":`Edit course ${i.name}`},"edit");n.dataset.fixed="false",n.addEventListener("click",()=>{e.edit(i)});let s=A("div",{class:"card-buttons"},t,n);i.from!=="given"&&s.append(A("a",{href:`/courses/${i.name}.toml`,download:""},"file")),i.from==="own"&&s.append(eP(i,e));let r=A("li",{class:"card",id:`course-${i.name}`},tP(i),A("div",{class:"card-text"},A("h3",{},i.name,...i.from==="own"?[A("span",{class:"card-own"}," yours")]:[]),A("p",{class:"card-about"},i.description??""),A("p",{class:"card-facts"},mv(i))),s);return i.in_force&&r.setAttribute("aria-current","true"),i.why_not!==""&&r.append(A("p",{class:"card-why"},i.why_not)),r}function eP(i,e){let t=A("button",{type:"button",class:"link card-delete"},"delete");return t.dataset.fixed=String(i.in_force),lc(t,"really delete",()=>{e.remove(i)}),t}function tP(i){let e=nd("svg",{class:"card-outline",role:"img","aria-label":`Outline of course ${i.name}`}),t=i.outline??[];if(t.length===0)return e;let n=p=>(p??[]).map(m=>Ys(m,m.length_m,m.width_m)),s=[...n(i.ramps),...n(i.blocks)],r=[...t.map(({x_m:p,y_m:m})=>({x:p,y:m})),...s.flat()],[o,a]=[r.map(({x:p})=>p),r.map(({y:p})=>p)],[l,c]=[Math.min(...o)-td,Math.max(...a)+td],h=Math.max(...o)+td-l,u=c-Math.min(...a)+td;e.setAttribute("viewBox",`${l} ${-c} ${h} ${u}`);let d=p=>p.map(({x:m,y:x})=>`${m.toFixed(3)},${(-x).toFixed(3)}`).join(" "),f=(p,m)=>{for(let x of p)e.append(nd("polygon",{points:d(x),fill:m}))};f(n(i.surfaces),oa),f(s,Sr);let g=t.map(({x_m:p,y_m:m})=>({x:p,y:m}));e.append(nd("polyline",{points:d(g),fill:"none",stroke:Ji,"stroke-width":"1.5","stroke-linejoin":"round","vector-effect":"non-scaling-stroke"}));let y=i.start;if(y!==void 0){let p=.05*Math.max(h,u);e.append(nd("circle",{cx:String(y.x_m),cy:String(-y.y_m),r:String(p),fill:Ni.fused}))}return e}function nd(i,e){let t=document.createElementNS("http://www.w3.org/2000/svg",i);for(let[n,s]of Object.entries(e))t.setAttribute(n,s);return t}var nP=5e3,iP={stand:"tracks turn freely, everything else is virtual",flat:"a flat floor; ramps and blocks are virtual",terrain:"ramps and blocks are really there"},sP="The real floor does not change with the course: with set-up terrain its ramps and blocks must stand there. An emulated robot keeps the floor and the disturbances that it was started with.",id=class{constructor(e,t,n,s=()=>performance.now()){this.ask=e;this.drawPlace=t;this.editor=n;this.now=s;this.element.append(A("div",{class:"courses-bar"},A("label",{},"robot ",this.robots),A("label",{},"set-up ",this.setups),this.placeStart,this.placeMap,this.upload,this.drawNew,this.file),this.why,A("div",{class:"courses-answer"},this.said,this.replace),this.cards,A("p",{class:"courses-floor"},sP)),this.robots.addEventListener("change",()=>{this.change({name:"choose",request:{robot:this.robots.value}})}),this.setups.addEventListener("change",()=>{this.change({name:"choose",request:{setup:this.setups.value}})}),this.placeStart.addEventListener("click",()=>{this.change({name:"place",request:{at:"start"}})}),this.placeMap.addEventListener("click",()=>{this.drawPlace(this.placeMap.getAttribute("aria-pressed")!=="true")}),this.upload.addEventListener("click",()=>{this.file.click()}),this.drawNew.addEventListener("click",()=>{this.editor.openNew(this.list?.courses.map(({name:r})=>r)??[])}),this.file.addEventListener("change",()=>{let r=this.file.files?.[0];r!==void 0&&this.take(r),this.file.value=""}),this.replace.addEventListener("click",()=>{let r=this.replaced;r!==void 0&&this.save(r,!0)}),this.dropFiles()}ask;drawPlace;editor;now;element=A("div",{class:"courses",tabindex:"0"});robots=A("select",{id:"choose-robot","aria-label":"Robot"});setups=A("select",{id:"choose-setup","aria-label":"Set-up"});placeStart=A("button",{type:"button",class:"control",id:"place-start"},"Place at start");placeMap=A("button",{type:"button",class:"control",id:"place-map","aria-pressed":"false"},"Place on the map");upload=A("button",{type:"button",class:"control",id:"upload"},"Upload");drawNew=A("button",{type:"button",class:"control",id:"draw-new"},"Draw a course");file=A("input",{type:"file",accept:".toml","aria-label":"Course or robot file",hidden:""});why=A("p",{class:"courses-why",role:"status"});said=A("p",{class:"courses-said",role:"alert"});replace=A("button",{type:"button",class:"control",id:"upload-replace",hidden:""},"Replace it");cards=A("ol",{class:"cards"});list;shown="";next_ms=0;asking=!1;mayChange=!1;replaced;show(e,t,n){let s=e.get("/state"),r=rP(s,t&&!e.stale("/state"),n);this.mayChange=r===""&&!this.asking,Ne(this.why,r),this.enable();let o=`${s?.course??""} ${s?.robot??""} ${s?.setup??""}`;this.element.dataset.named!==o&&(this.next_ms=0),this.element.dataset.named=o,!(this.now()<this.next_ms||!t)&&(this.next_ms=this.now()+nP,this.load())}get changeable(){return this.mayChange}placed(e){Ke(this.placeMap,"aria-pressed","false"),e!==void 0&&this.change({name:"place",request:e})}drawing(e){Ke(this.placeMap,"aria-pressed",String(e)),e&&this.say("Press on the map where the robot is, and drag towards where it points.")}enable(){let e=this.mayChange&&this.list!==void 0;for(let t of[this.robots,this.setups,this.placeMap])t.disabled=!e;this.placeStart.disabled=!e||this.list?.course==="",this.drawNew.disabled=this.list===void 0,this.upload.disabled=this.replace.disabled=!e||this.list?.may_save!==!0,Ke(this.upload,"title",this.list?.may_save===!1?"There is no folder for your files: set library in the configuration":"A course or robot file (TOML)");for(let t of this.cards.querySelectorAll("button"))t.disabled=!e||t.dataset.fixed==="true"}async load(){try{let e=await fetch("/api/setup",{cache:"no-store"});if(!e.ok)throw new Error(e.statusText);let t=await e.text();if(t===this.shown)return;this.shown=t,this.list=JSON.parse(t),this.build(this.list)}catch{this.shown="",this.say("The list of courses is not available now.")}}build(e){let t=(o,a,l)=>{let c=A("option",{value:o},a===""?o:`${o}: ${a}`);return c.disabled=l!=="",l!==""&&(c.title=l),c};this.robots.replaceChildren(...e.robots.map(o=>t(o.name,o.description??"",o.why_not))),this.robots.value=e.robot,this.setups.replaceChildren(...e.setups.map(o=>t(o,iP[o]??"",""))),this.setups.value=e.setup;let n=o=>+(o.identifies===!0)-+(o.from!=="bundled"),s=[...e.courses].sort((o,a)=>n(o)-n(a)),r={edit:o=>{this.edit(o)},choose:({name:o})=>{this.change({name:"choose",request:{course:o}})},remove:({name:o})=>{this.change({name:"file_delete",request:{kind:"course",name:o}})}};this.cards.replaceChildren(...s.map(o=>Ny(o,r))),this.enable()}async edit({name:e,from:t}){try{let n=await fetch(`/courses/${e}.toml`,{cache:"no-store"});if(!n.ok)throw new Error(`${e} cannot be read: ${n.statusText}`);let s=t==="own";this.editor.open(s?e:`${e}-mine`,await n.text(),s)}catch(n){this.say(n instanceof Error?n.message:String(n))}}async change(e){this.asking=!0,this.mayChange=!1,this.say(""),this.enable();try{return await this.ask(e),!0}catch(t){return this.say(t instanceof Error?t.message:String(t)),!1}finally{this.asking=!1,this.shown="",this.next_ms=0}}async take(e){if(e.size>6e4){this.say(`${e.name} has ${e.size} bytes; at most ${6e4} are taken`);return}let t=await e.text();await this.save({kind:pv(t),name:fu(e.name),text:t},!1)}async save(e,t){let n=e.kind==="course"?this.list?.courses:this.list?.robots;if(!t&&n?.some(({name:s,from:r})=>s===e.name&&r==="own")===!0){this.say(`You have a ${e.kind} named ${e.name} already.`),this.replaced=e,this.replace.hidden=!1;return}await this.change({name:"file_save",request:{...e,replace:t}})&&this.say(`${e.name} is saved.`)}say(e){this.replaced=void 0,this.replace.hidden=!0,Ne(this.said,e)}dropFiles(){this.element.addEventListener("dragover",e=>{e.preventDefault(),this.element.classList.add("dropping")}),this.element.addEventListener("dragleave",()=>{this.element.classList.remove("dropping")}),this.element.addEventListener("drop",e=>{e.preventDefault(),this.element.classList.remove("dropping");let t=e.dataTransfer?.files[0];t!==void 0&&!this.upload.disabled&&this.take(t)})}};function rP(i,e,t){return!e||i===void 0?"No connection to tp100d.":t?i.run==="arming"||i.run==="running"?"A run is under way: nothing can be changed.":i.run==="driving"?"The robot is driven by hand: release it first.":"":"This daemon takes no commands from here but STOP (server.commands)."}var sd=[{part:"port",title:"Port"},{part:"robot",title:"Robot"},{part:"machine",title:"Machine"}],Pm=(i,e)=>`${i} ${e}${i===1?"":"s"}`;function Oy(i){let e=o=>i.filter(a=>a.severity===o).length,[t,n,s]=[e("error"),e("warning"),e("note")];return`${t>0?"Not ready to drive":"Ready to drive"}: ${Pm(t,"error")}, ${Pm(n,"warning")}, ${Pm(s,"note")}.`}var rd=class{constructor(e){this.call=e;this.element.append(A("div",{class:"doctor-bar"},this.button,this.progress,this.said),this.list),this.button.addEventListener("click",()=>{this.examine()})}call;element=A("div",{class:"doctor",tabindex:"0"});button=A("button",{type:"button",class:"control",id:"doctor-examine"},"Examine");said=A("p",{class:"doctor-said",role:"status"},"Finds what keeps the robot from driving. Nothing moves.");progress=A("progress",{max:String(sd.length),value:"0","aria-label":"Examined",hidden:""});list=A("div",{class:"doctor-list"});busy=!1;show(e,t,n){let s=e.get("/state")?.run,r=s==="arming"||s==="running"||s==="driving";this.button.disabled=this.busy||!t||!n||r;let o=n?r?"A run is under way; stop it first":"":"This daemon takes no commands from here but STOP (server.commands)";Ke(this.button,"title",o)}async examine(){this.busy=this.button.disabled=!0,this.progress.hidden=!1,this.list.replaceChildren();let e=[],t="";for(let[n,{part:s,title:r}]of sd.entries()){this.progress.value=n,this.say(`${r}, ${n+1} of ${sd.length} …`);try{let{findings:o}=await this.call(s);e.push(...o),this.list.append(A("section",{"data-part":s,"aria-label":r},A("h3",{},r),A("ul",{},...o.map(oP))))}catch(o){t=`${r} not examined: ${o instanceof Error?o.message:String(o)}`;break}}this.progress.hidden=!0,this.busy=!1,this.say(t===""?Oy(e):t,t!==""||e.some(({severity:n})=>n==="error"))}say(e,t=!1){Ne(this.said,e),St(this.said,"bad",t)}};function oP({severity:i,name:e,seen:t,fix:n}){let s=A("div",{class:"finding-about"},A("p",{},t));return n!==""&&s.append(A("p",{class:"finding-fix"},`To do: ${n}`)),A("li",{class:"finding","data-severity":i,"data-name":e},A("span",{class:"finding-severity"},i),A("strong",{},e),s)}var aP=3e3,lP="This daemon takes no commands from here but STOP (server.commands)",cP={none:"no control held",keys:"keys",stick:"stick",gamepad:"gamepad"},od=class{constructor(e,t,n=()=>performance.now()){this.driver=e;this.inputs=t;this.now=n;this.stick=new Rm(s=>{t.touch(s),e.tick()}),this.button.append(hs("wheel"),this.label),this.button.addEventListener("click",()=>{this.press()}),this.release.addEventListener("click",()=>{e.release()}),this.share.addEventListener("input",()=>{e.share=this.share.valueAsNumber/100});for(let[s,r]of[["speed","speed"],["turn","turn"]]){let o=A("dd",{id:`drive-${s}`});this.values.set(s,o),this.facts.append(A("dt",{},r),o)}this.element.append(this.stick.element,A("div",{class:"drive-text"},this.source,this.facts,A("label",{class:"drive-limit",for:"drive-share"},"at most ",this.shareText),this.share,this.asked),this.release)}driver;inputs;now;button=A("button",{type:"button",id:"drive",class:"control","aria-keyshortcuts":"m"});element=A("section",{class:"drive-panel","aria-label":"Driving by hand",hidden:""});label=A("span",{class:"button-label"},"Drive");stick;source=A("p",{class:"drive-source",role:"status"});facts=A("dl",{class:"drive-facts"});values=new Map;share=A("input",{type:"range",id:"drive-share",min:"10",max:"100",step:"5",value:"50","aria-label":"Greatest speed"});shareText=A("output",{for:"drive-share"});asked=A("p",{class:"drive-asked",role:"status"});release=A("button",{type:"button",class:"control",id:"drive-release"},"Release");confirmUntil_ms=0;needsConfirmation=!0;press(){if(this.button.disabled||this.driver.drives)return;let e=this.now();if(this.needsConfirmation&&e>this.confirmUntil_ms){this.confirmUntil_ms=e+aP;return}this.confirmUntil_ms=0,this.driver.take()}forget(){this.confirmUntil_ms=0}show(e,t,n){let s=e.get("/state"),r=t&&n&&s!==void 0&&!e.stale("/state");this.showButton(s,r,n);let o=this.driver.drives;if(this.element.hidden===o&&(this.element.hidden=!o),!o){this.stick.letGo();return}let a=e.get("/parameter")?.parameters??[],l=(c,h)=>{let u=a.find(d=>d.name===c)?.value;return typeof u=="number"?u:h};this.driver.limits={speed_mps:l("robot.drive.max_track_mps",.2),yaw_rate_radps:l("robot.drive.max_yaw_radps",1)},this.showDrive(e,s)}showButton(e,t,n){this.needsConfirmation=e?.confirm_start!==!1;let s=e?.driver?.fresh===!0&&!this.driver.drives;this.button.disabled=!(t&&!this.driver.drives&&(e?.can.drive===!0||s));let r=this.now()<this.confirmUntil_ms;St(this.button,"confirm",r),Ne(this.label,r?"Press again":s?"Ask":"Drive");let o=n?e?.why_not_drive??"":lP,a=s?`${o}: ask for the wheel`:o;Ke(this.button,"title",a===""?"Drive by hand (m)":a)}showDrive(e,t){let n=this.driver.wish,s=e.get("/estimate"),r=s?.[s.steering],o=t?.run==="driving";St(this.element,"frozen",this.inputs.frozen);let a=this.inputs.frozen?"gamepad: its values stand still; move the stick":o?s?.at_fence===!0?"at the fence":cP[n?.source??"none"]:"arming…";Ne(this.source,a);let{speed_mps:l,yaw_rate_radps:c}=this.driver.limits,h=`${at(r?.vx_mps,3)} m/s, commanded ${at(s?.desired_speed_mps,3)}`,u=`${bs(r?.yaw_rate_radps,0)}°/s, wanted ${bs((n?.left??0)*this.driver.share*c,0)}`,[d,f]=[this.values.get("speed"),this.values.get("turn")];d&&Ne(d,h),f&&Ne(f,u);let g=this.driver.share*l;Ne(this.shareText,`${at(g,2)} of ${at(l,2)} m/s, ${bs(this.driver.share*c,0)}°/s`);let y=t?.driver?.asked_by??"";Ne(this.asked,y===""?"":`${y} asks for the wheel`),this.stick.show(n?.forward??0,n?.left??0)}},Rm=class{constructor(e){this.moved=e;this.element.append(this.knob),this.element.addEventListener("pointerdown",t=>{this.pointer!==void 0||t.button!==0||(t.preventDefault(),this.pointer=t.pointerId,this.element.setPointerCapture(t.pointerId),this.move(t))}),this.element.addEventListener("pointermove",t=>{t.pointerId===this.pointer&&this.move(t)});for(let t of["pointerup","pointercancel","lostpointercapture"])this.element.addEventListener(t,n=>{n.pointerId===this.pointer&&this.letGo()})}moved;element=A("div",{class:"drive-stick","aria-hidden":"true"});knob=A("div",{class:"drive-knob"});pointer;letGo(){this.pointer!==void 0&&(this.pointer=void 0,this.moved(void 0))}show(e,t){this.knob.style.transform=`translate(${(-75*t).toFixed(1)}%, ${(-75*e).toFixed(1)}%)`}move(e){let t=this.element.getBoundingClientRect(),n=t.width/2,s=(e.clientX-t.left-n)/n,r=(e.clientY-t.top-n)/n,o=Math.max(1,Math.hypot(s,r)),a=l=>Math.abs(l)<.08?0:l;this.moved({forward:a(-r/o),left:a(-s/o)})}};var ad=class{constructor(e){this.pages=e;let t=A("div",{class:"tabs",role:"tablist"});this.tabs=e.map((s,r)=>{let o=A("button",{type:"button",role:"tab",id:`tab-${s.id}`,"aria-controls":`page-${s.id}`},s.title);return o.addEventListener("click",()=>{this.choose(r)}),o.addEventListener("keydown",a=>{let l={ArrowRight:1,ArrowLeft:-1}[a.key];l!==void 0&&(this.choose((this.current+l+e.length)%e.length),this.tabs[this.current]?.focus())}),o}),t.append(...this.tabs);let n=A("button",{type:"button",id:"drawer-size","aria-pressed":"false",title:"More room for these pages"},"larger");n.addEventListener("click",()=>{let s=document.body.classList.toggle("large-drawer");Ke(n,"aria-pressed",String(s)),Ne(n,s?"smaller":"larger")}),this.element.append(A("div",{class:"drawer-head"},t,n));for(let s of e)Ke(s.element,"id",`page-${s.id}`),Ke(s.element,"role","tabpanel"),Ke(s.element,"aria-labelledby",`tab-${s.id}`),s.element.classList.add("page"),this.element.append(s.element);this.choose(0)}pages;element=A("section",{class:"drawer","aria-label":"Details"});tabs;current=0;show(){this.pages[this.current]?.show()}get selected(){return this.pages[this.current]?.id??""}select(e){this.choose(this.pages.findIndex(t=>t.id===e))}choose(e){this.current=e,this.pages.forEach((t,n)=>{let s=n===e;t.element.hidden=!s;let r=this.tabs[n];r!==void 0&&(Ke(r,"aria-selected",String(s)),r.tabIndex=s?0:-1)}),this.show()}};var ld=class{since_s;low=!1;limit_v=NaN;take(e,t,n){this.limit_v=n??NaN;let s=this.limit_v+.3;if(!(typeof t=="number"&&t>4&&n!==void 0&&n>0)||t>s+(this.low?.1:0)){this.since_s=void 0,this.low=!1;return}(this.since_s===void 0||e<this.since_s)&&(this.since_s=e),e-this.since_s>=2&&(this.low=!0)}};var la=class{constructor(e,t,n=0){this.width=e;this.capacity=t;this.interval_s=n;this.columns=Array.from({length:e},()=>new Float64Array(2*t))}width;capacity;interval_s;columns;end=0;filled=0;get length(){return this.filled}get first_s(){return this.filled===0?NaN:this.columns[0]?.[this.end-this.filled]??NaN}get last_s(){return this.filled===0?NaN:this.columns[0]?.[this.end-1]??NaN}push(e){let t=e[0]??NaN;if(this.filled>0){if(t<this.last_s)this.clear();else if(t-this.last_s<this.interval_s)return}if(this.end===2*this.capacity){for(let n of this.columns)n.copyWithin(0,this.capacity);this.end=this.capacity}for(let n=0;n<this.width;n++){let s=this.columns[n];s!==void 0&&(s[this.end]=e[n]??NaN)}this.end++,this.filled=Math.min(this.filled+1,this.capacity)}before(e){let t=this.since(-1/0).map(r=>r.slice()),n=this.filled,s=n===0?1/0:this.first_s;this.clear();for(let r of e)(r[0]??NaN)<s&&this.push(r);for(let r=0;r<n;r++)this.push(t.map(o=>o[r]??NaN))}clear(){this.end=0,this.filled=0}since(e){let t=this.columns[0],n=this.end-this.filled,s=this.end;for(;t!==void 0&&n<s;){let o=n+s>>1;(t[o]??1/0)<e?n=o+1:s=o}let r=Math.max(n-1,this.end-this.filled);return this.columns.map(o=>o.subarray(r,this.end))}};var Zr=class{constructor(e=4e3,t=.01){this.capacity=e;this.firstSpacing_m=t;this.points=new Float32Array(3*e),this.spacing_m=t}capacity;firstSpacing_m;points;count=0;spacing_m;changes=0;get length(){return this.count}get generation(){return this.changes}get coordinates(){return this.points.subarray(0,3*this.count)}add(e,t,n){if(!Number.isFinite(e+t+n))return;let s=3*(this.count-1);this.count>0&&Math.hypot(e-(this.points[s]??0),t-(this.points[s+1]??0))<this.spacing_m*.999||(this.count===this.capacity&&this.thin(),this.points.set([e,t,n],3*this.count),this.count++)}clear(){this.count=0,this.spacing_m=this.firstSpacing_m,this.changes++}thin(){let e=this.count>>1;for(let t=0;t<e;t++)this.points.copyWithin(3*t,6*t,6*t+3);this.count=e,this.spacing_m*=2,this.changes++}};var si=["model","odometry","fused","truth"],Lm={t_s:0,desired_yaw_deg:1,model_yaw_deg:2,odometry_yaw_deg:3,fused_yaw_deg:4,truth_yaw_deg:5,cross_track_mm:6,heading_error_deg:7,left_mps:8,right_mps:9,left_commanded_mps:10,right_commanded_mps:11,slip_left_percent:12,slip_right_percent:13,fused_slip_left_percent:14,fused_slip_right_percent:15,model_error_mm:16,odometry_error_mm:17,fused_error_mm:18},Im=120,Uy=.0199,Dm=300,hP=.5,uP={"/estimate":400,"/slip":600,"/sample":400,"/command":400,"/link":1e3,"/loop":1500,"/state":1e3,"/course":1/0,"/event":1/0,"/parameter":1/0,"/recording":1/0,"/client":3e3,"/path_history":1/0},dP=4e5,zl=class{constructor(e=()=>performance.now()){this.now=e}now;series=new la(Object.keys(Lm).length,Math.ceil(Im/Uy),Uy);path_histories={model:new Zr,odometry:new Zr,fused:new Zr,truth:new Zr};events=[];battery=new ld;leftTrack_m=0;rightTrack_m=0;received={};latest={};received_ms={};get(e){return this.latest[e]}receive(e,t){e==="/estimate"?this.estimate(t):e==="/event"?this.event(t):e==="/state"?this.state(t):e==="/path_history"&&this.history(t),this.latest[e]=t,this.received_ms[e]=this.now(),this.received[e]=(this.received[e]??0)+1}stale(e){let t=this.received_ms[e];if(t===void 0||this.now()-t>uP[e])return!0;if(e!=="/estimate"&&e!=="/slip")return!1;let n=this.latest["/estimate"]?.age_us;return n==null||n>dP}get pose(){let e=this.latest["/estimate"];return e?.[e.steering]}before(e,t){let n=0;this.series.before(e.map(s=>{for(;(t[n+1]?.t_s??1/0)<=s.t_s;)n++;return Fy(s,t[n])}))}clear(){this.series.clear(),this.clearTrails(),this.events.length=0,this.leftTrack_m=this.rightTrack_m=0;for(let e of Object.keys(this.latest))Reflect.deleteProperty(this.latest,e)}clearTrails(){for(let e of si)this.path_histories[e].clear()}estimate(e){let t=this.latest["/estimate"];if(t!==void 0){let n=e.t_s-t.t_s;n>0&&n<1&&(this.leftTrack_m+=e.tracks.left_mps*n,this.rightTrack_m+=e.tracks.right_mps*n),(Math.hypot(e.model.x_m-t.model.x_m,e.model.y_m-t.model.y_m)>hP||n<0)&&this.clearTrails()}for(let n of si){let s=e[n];s&&this.path_histories[n].add(s.x_m,s.y_m,s.z_m)}this.series.push(Fy(e,this.latest["/slip"]))}event(e){this.events.some(n=>n.t_s===e.t_s&&n.text===e.text)||(this.events.push(e),this.events.length>Dm&&this.events.shift())}state(e){e.run==="running"&&this.latest["/state"]?.run==="arming"&&this.clearTrails();let n=this.latest["/parameter"]?.parameters.find(({name:s})=>s==="control.min_battery_v")?.value;this.battery.take(e.t_s,e.battery_v,typeof n=="number"?n:void 0)}history(e){for(let t of["model","odometry","fused"]){let n=this.path_histories[t];if(n.length>10)continue;let s=e.entities.filter(r=>r.id.startsWith(`path_history/${t}/`));if(s.length!==0){n.clear();for(let r of s)for(let o of r.lines)for(let{x:a,y:l,z:c}of o.points)n.add(a,l,c)}}}};function Fy(i,e){let{model:t,odometry:n,fused:s,truth:r,tracks:o}=i,a=c=>(c??NaN)*180/Math.PI,l=c=>r?1e3*Math.hypot(c.x_m-r.x_m,c.y_m-r.y_m):NaN;return[i.t_s,a(i.desired_yaw_rad),a(t.yaw_rad),a(n.yaw_rad),a(s.yaw_rad),a(r?.yaw_rad),1e3*i.cross_track_m,a(i.heading_error_rad),o.left_mps,o.right_mps,o.left_commanded_mps??NaN,o.right_commanded_mps??NaN,100*(e?.left??NaN),100*(e?.right??NaN),100*(e?.fused_left??NaN),100*(e?.fused_right??NaN),l(t),l(n),l(s)]}var fP=["info","warning","error"],cd=class{element=A("div",{class:"events",tabindex:"0"});list=A("ol",{class:"event-list",role:"log"});level=A("select",{"aria-label":"Level of events"});search=A("input",{type:"search",placeholder:"search","aria-label":"Search events"});none=A("p",{class:"empty",hidden:""},"No event matches.");shown=[];source;began_unix_s;constructor(e=[]){["all events","warnings, errors","errors"].forEach((t,n)=>{this.level.append(A("option",{value:String(n)},t))});for(let t of[this.level,this.search])t.addEventListener("input",()=>{this.narrow()});this.element.append(A("div",{class:"events-bar"},this.level,this.search,...e),this.list,this.none)}show(e,t){(e!==this.source||e.events.length===0||t!==this.began_unix_s)&&(this.source=e,this.began_unix_s=t,this.shown=[],this.list.replaceChildren());let n=this.shown.at(-1),s=n===void 0?0:e.events.lastIndexOf(n)+1;if(s!==e.events.length){for(let r of e.events.slice(s))this.list.prepend(pP(r,t));for(;this.list.children.length>Dm;)this.list.lastElementChild?.remove();this.shown=e.events.slice(-1),this.narrow()}}narrow(){let e=this.search.value.trim().toLowerCase().split(/\s+/),t=this.list.children.length===0;for(let n of this.list.children){if(!(n instanceof HTMLElement))continue;let s=n.textContent.toLowerCase();n.hidden=fP.indexOf(n.dataset.level??"")<Number(this.level.value)||!e.every(r=>s.includes(r)),t||=!n.hidden}this.none.hidden=t}};function pP(i,e){let t=[i.cause,i.fix].filter(r=>r!=="").join(" — "),n=Ii(i.t_s),s=e===void 0?n:Iy(e+i.t_s);return A("li",{class:"event","data-level":i.level,"data-kind":i.kind},A("time",{title:`${n} since the start of tp100d`},s),A("span",{class:"event-kind"},i.kind),A("span",{class:"event-text"},i.text,...t===""?[]:[A("span",{class:"event-cause"},t)]))}var hd=class{element;bars=A("div",{class:"bars",role:"img"});labels=A("div",{class:"bar-labels","aria-hidden":"true"});figures;edges="";shown=-1;constructor(){let e=()=>A("span",{class:"plot-value wide"});this.figures={p50:e(),"p99.9":e(),max:e()};let t=A("div",{class:"plot-key"});for(let[n,s]of Object.entries(this.figures))t.append(A("span",{class:"plot-curve"},n,s));this.element=A("section",{class:"plot histogram",id:"plot-lateness","aria-label":"Lateness of the loop"},A("header",{},A("h2",{},"Loop lateness",A("span",{class:"plot-unit"},"cycles, log")),t),this.bars,this.labels)}show(e){let t=e.get("/loop");St(this.element,"stale",e.stale("/loop"));let n=e.received["/loop"]??0;if(t===void 0||n===this.shown)return;this.shown=n;let{edges_us:s,lateness:r}=t.histogram;this.build(s);let o=Math.log10(Math.max(10,...r)+1);r.forEach((l,c)=>{let h=this.bars.children[c];if(h===void 0)return;h.style.transform=`scaleY(${(l===0?0:Math.max(.02,Math.log10(l+1)/o)).toFixed(3)})`;let u=c===0?"below ":`${qt(s[c-1])} to `;Ke(h,"title",`${c===s.length?"over "+qt(s.at(-1)):u+qt(s[c])}: ${Bn(l)}`)}),Ne(this.figures.p50,qt(t.lateness_us.p50)),Ne(this.figures["p99.9"],qt(t.lateness_us.p999)),Ne(this.figures.max,qt(t.lateness_us.max));let a=`median ${qt(t.lateness_us.p50)}, worst ${qt(t.lateness_us.max)} of ${Bn(t.cycles)} turns`;Ke(this.bars,"aria-label",a)}reset(){this.shown=-1,this.edges="",this.bars.replaceChildren(),this.labels.replaceChildren();for(let e of Object.values(this.figures))Ne(e,"")}build(e){let t=e.join();t!==this.edges&&(this.edges=t,this.bars.replaceChildren(...[...e,0].map(()=>A("i"))),this.labels.replaceChildren(...[...e,0].map((n,s)=>{let r=s<e.length&&Number.isInteger(Math.log10(n));return A("span",{},...r?[A("b",{},qt(n))]:[])})))}};var ud=class{badge=A("span",{class:"badge"});setting=A("span",{class:"setting"});element=A("div",{class:"identity"},A("h1",{},"TP100"),this.setting,this.badge);show(e,t){let n=e.get("/state"),s=[n?.robot??t.robot,n?.setup??t.setup].filter(Boolean);Ne(this.setting,s.join(" · "));let r=n===void 0?"TP100":`${n.run} · TP100`;document.title!==r&&(document.title=r);let o=e.get("/link")?.kind;Ne(this.badge,mP(o)),Ke(this.badge,"data-kind",o??"")}};function mP(i){return i==="simulated"?"simulated inside the board":i??""}var gP=[["space, esc","STOP"],["r","start; asks for confirmation, or where the robot stands"],["p","pause: stands still on the path, armed; again: goes on"],["h","hold: ends the run or the drive and disarms"],["m","drive by hand: takes the wheel; asks for confirmation"],["arrows; w, a, s, d","while this page drives: forwards, left, backwards, right, as long as they are held"],["1, 2, 3, 4","view: chase, top, free, map"],["c","next view"],["[, ]","step through a recording"],["?","this list"],["tab, arrows","from control to control; between the tabs"]];function By(){let i=A("dl",{class:"keys"});for(let[e,t]of gP)i.append(A("dt",{},A("kbd",{},e)),A("dd",{},t));return i}var dd=({p50:i,p99:e})=>`${qt(i)}, ${qt(e)}`,fd=class{element=A("div",{class:"facts",tabindex:"0"});groups=new Map;show(e){let t=e.get("/link"),n=e.get("/loop"),s=e.get("/client");t!==void 0&&(this.group("Link",e.stale("/link"),[["port",t.port],["robot",t.kind??"–"],["firmware",t.firmware??"–"],["session",t.session],["samples",`${at(t.samples_hz,1)} Hz`],["in, out",`${Di(t.in_bytes_ps)}/s, ${Di(t.out_bytes_ps)}/s`],["round trip",qt(t.round_trip_us)],["clock",t.clock.valid?`${at(t.clock.drift_ppm,1)} ppm ±${qt(t.clock.uncertainty_us)}`:"–"],["sample age p50",qt(t.sample_age_us.p50)],["sample age p99.9",qt(t.sample_age_us.p999)]]),this.group("Counters",e.stale("/link"),Object.entries(t.counters).map(([r,o])=>[r.replaceAll("_"," "),Bn(o)]))),n!==void 0&&this.group("Loop",e.stale("/loop"),[["rate",`${at(n.rate_hz,0)} Hz, by ${n.pacing}`],["cycles",Bn(n.cycles)],["overruns, missed",`${Bn(n.overruns)}, ${Bn(n.missed)}`],["lateness p50",qt(n.lateness_us.p50)],["lateness p99.9",qt(n.lateness_us.p999)],["lateness max",qt(n.lateness_us.max)],["work p50",qt(n.work_us.p50)],["work max",qt(n.work_us.max)],["compute p50, p99",dd(n.compute_us)],["write p50, p99",dd(n.write_us)],["sample on the wire p50, p99",dd(n.sample_wire_us)],["sample waits p50, p99",dd(n.sample_wait_us)],...Object.entries(n.privileges).map(([r,o])=>[r,o?"granted":"refused"])]),s!==void 0&&this.group("Viewers",e.stale("/client"),[["dropped, refused, closed",[s.dropped_total,s.refused_total,s.closed_total].map(Bn).join(", ")],...s.clients.slice(0,20).map(r=>[`${r.id} ${r.address}`,`${Bn(r.sent)} sent, ${Bn(r.dropped)} dropped`])])}group(e,t,n){let s=this.groups.get(e);if(s===void 0){let o=A("dl");s={box:A("section",{class:"fact-group"},A("h3",{},e),o),list:o},this.groups.set(e,s),this.element.append(s.box)}St(s.box,"stale",t);let{list:r}=s;for(;r.children.length>2*n.length;)r.lastElementChild?.remove();n.forEach(([o,a],l)=>{r.children.length<2*l+2&&r.append(A("dt"),A("dd"));let[c,h]=[r.children[2*l],r.children[2*l+1]];c&&Ne(c,o),h&&Ne(h,a)})}};var _P=6e3,pd=class{element=A("div",{class:"notice",role:"status","data-level":"none"});list=A("ul",{id:"notice-list"});more=A("button",{type:"button",id:"notice-more","aria-controls":"notice-list","aria-expanded":"false"});close=A("button",{type:"button",id:"notice-close","aria-label":"Close this notice"},hs("close"));answer="";answerUntil_ms=0;all=[];open=!1;closed="";shown="";constructor(){this.element.append(this.list,this.more,this.close),this.more.addEventListener("click",()=>{this.open=!this.open,this.render()}),this.close.addEventListener("click",()=>{this.closed=Nm(this.all),this.answerUntil_ms=0,this.render()})}say(e,t){this.answer=e,this.answerUntil_ms=t+_P,this.closed=""}show(e,t,n,s,r){this.all=vP(e,t,n,r),t&&s<this.answerUntil_ms&&this.all.unshift({level:"warn",what:this.answer,todo:""}),this.render()}render(){this.closed!==""&&this.closed!==Nm(this.all)&&(this.closed="");let e=this.closed===""?this.all:[],t=this.open?e:e.slice(0,1),n=Nm(t);n!==this.shown&&(this.shown=n,this.list.replaceChildren(...t.map(({what:r,todo:o})=>A("li",{},A("strong",{},r)," ",A("span",{},o))))),Ke(this.element,"data-level",t[0]?.level??"none");let s=e.length-1;this.more.hidden=s<1,Ne(this.more,this.open?"less":`+${s}`),Ke(this.more,"aria-label",this.open?"Show the first notice only":`Show ${s} more`),Ke(this.more,"aria-expanded",String(this.open))}},Nm=i=>JSON.stringify(i);function vP(i,e,t,n){if(!e)return[{level:"bad",what:"No connection to tp100d",todo:t>0?"trying again":"connecting"}];let s=i.get("/state");if(s===void 0)return[];let r=[];if(i.stale("/state")&&r.push({level:"bad",what:"The daemon is silent",todo:"grey values are old"}),s.session!=="ready"&&!n){let a=i.get("/link"),l=a===void 0||a.port===""?"No robot":`No robot on ${a.port}`,c=(a?.note??"").replace(`${a?.port??""}: `,"");r.push({level:"warn",what:l,todo:s.session==="closed"?c:s.why_not_start})}let o=s.run==="finished"?"warn":"bad";for(let a of s.faults)a.name!=="stop_requested"&&r.push({level:o,what:a.cause,todo:a.fix});return i.battery.low&&!n&&r.push({level:"warn",what:"The battery is low",todo:`below ${at(i.battery.limit_v,2)} V a run is aborted; charge it before the next one`}),r}var yP=[{id:"x",label:"x",unit:"m",topic:"/estimate",text:i=>at(i.pose?.x_m,3)},{id:"y",label:"y",unit:"m",topic:"/estimate",text:i=>at(i.pose?.y_m,3)},{id:"yaw",label:"yaw",unit:"°",topic:"/estimate",text:i=>bs(i.pose?.yaw_rad,1)},{id:"climb",label:"pitch, nose up",unit:"°",topic:"/estimate",text:i=>bs(i.pose===void 0?null:-i.pose.pitch_rad,1)},{id:"cross-track",label:"cross-track",unit:"mm",topic:"/estimate",text:i=>Ly(i.get("/estimate")?.cross_track_m,1)},{id:"heading-error",label:"heading",unit:"°",topic:"/estimate",text:i=>bs(i.get("/estimate")?.heading_error_rad,1)},{id:"left",label:"left track",unit:"m/s",topic:"/estimate",text:i=>at(i.get("/estimate")?.tracks.left_mps,3)},{id:"right",label:"right track",unit:"m/s",topic:"/estimate",text:i=>at(i.get("/estimate")?.tracks.right_mps,3)},{id:"slip-left",label:"slip left",unit:"%",topic:"/slip",text:i=>Am(i.get("/slip")?.left,1)},{id:"slip-right",label:"slip right",unit:"%",topic:"/slip",text:i=>Am(i.get("/slip")?.right,1)},{id:"age",label:"data age",unit:"ms",topic:"/estimate",text:i=>at(zy(i),(zy(i)??0)<100?1:0)},{id:"battery",label:"battery",unit:"V",topic:"/state",text:i=>at(i.get("/state")?.battery_v,2)}];function zy(i){let e=i.get("/estimate")?.age_us??null;return e===null?null:Math.min(Math.max(e/1e3,0),99999)}var md=class{element=A("section",{class:"numbers","aria-label":"Figures"});rows;constructor(){this.rows=yP.map(e=>{let t=A("output",{class:"number-value",id:`number-${e.id}`},"–"),n=A("div",{class:"number stale"},A("span",{class:"number-label"},e.label),A("span",{class:"number-line"},t,A("span",{class:"number-unit"},e.unit)));return this.element.append(n),{figure:e,tile:n,value:t}})}show(e){for(let{figure:t,tile:n,value:s}of this.rows)Ne(s,t.text(e)),St(n,"stale",e.stale(t.topic)),t.id==="battery"&&St(n,"low",e.battery.low)}};function ca(i){return typeof i=="number"?Number(i.toPrecision(10)):i}function Jr(i){return i===""?'""':String(ca(i))}function Vl(i){return i.type==="choice"?i.choices.join(", "):typeof i.min!="number"||typeof i.max!="number"?"":`${Jr(i.min)} to ${Jr(i.max)}${i.unit===""?"":` ${i.unit}`}`}function Vy(i,e){if(i.type==="text")return{value:e};let t=e.trim()===""?NaN:Number(e);return Number.isFinite(t)?i.type==="integer"&&!Number.isInteger(t)?{why:`a whole number from ${Vl(i)}`}:t>=(i.min??-1/0)&&t<=(i.max??1/0)?{value:t}:{why:`allowed is ${Vl(i)}`}:{why:`a number from ${Vl(i)}`}}function Gy(i){let e=new Map;for(let t of i){let n=t.name.slice(0,Math.max(t.name.lastIndexOf("."),0))||"run";e.set(n,[...e.get(n)??[],t])}return[...e]}function Hy(i,e){let t=`${i.name} ${i.unit} ${i.meaning} ${i.choices.join(" ")}`.toLowerCase();return e.toLowerCase().split(/\s+/).every(n=>t.includes(n))}var gd=class{edits=new Map;inFile=new Map;get(e){return this.edits.get(e)}get names(){return[...this.edits.keys()]}set(e,t){ca(t)===ca(e.value)&&!this.inFile.has(e.name)?this.edits.delete(e.name):this.edits.set(e.name,t)}drop(e){this.edits.delete(e)}file(e){return this.inFile.get(e)}inForce(e){let t={};for(let n of e)n.may_save===!0&&n.type!=="text"&&(t[n.name]=ca(n.value));return t}wanted(e){let t={};for(let n of e){if(n.may_save!==!0)continue;let s=this.edits.get(n.name);s!==void 0?t[n.name]=ca(s):n.live&&(t[n.name]=ca(n.value))}return t}compared(e){this.inFile=new Map(e.differences.map(({name:t,before:n})=>[t,n]))}};var _d=class{constructor(e,t,n){this.edits=e;this.set=t;this.edited=n;this.filter.addEventListener("input",()=>{this.narrow()})}edits;set;edited;element=A("div",{class:"parameter-list"});filter=A("input",{type:"search",placeholder:"search","aria-label":"Search parameters"});none=A("p",{class:"empty",hidden:""},"No parameter matches.");shown=-1;groups=[];refresh(){this.shown=-1}show(e){let t=e.received["/parameter"]??0;t===this.shown||this.element.contains(document.activeElement?.closest(".parameter-value")??null)||(this.shown=t,this.groups=Gy(e.get("/parameter")?.parameters??[]).map(([n,s])=>{let r=s.map(a=>({parameter:a,row:this.row(a)})),o=A("h3",{},n,...n.startsWith("robot.")?[A("span",{}," of the robot’s file")]:[]);return{element:A("section",{"aria-label":n},o,...r.map(({row:a})=>a)),rows:r}}),this.element.replaceChildren(this.none,...this.groups.map(({element:n})=>n)),this.narrow())}narrow(){let e=this.filter.value.trim(),t=!1;for(let{element:n,rows:s}of this.groups){let r=!1;for(let{parameter:o,row:a}of s)a.hidden=!Hy(o,e),r||=!a.hidden;n.hidden=!r,t||=r}this.none.hidden=t}row(e){let t=this.edits.get(e.name),n=this.edits.file(e.name),s=e.value!==e.default,r=A("p",{class:"parameter-why",role:"alert"}),o=[Vl(e),`default ${Jr(e.default)}`].filter(Boolean).join(" · "),a=e.live?e.when==="not running"?"at once, not during a run":"at once":"";return A("div",{class:["parameter",e.live?"live":"",s?"changed":"",t===void 0?"":"edited"].filter(Boolean).join(" "),"data-name":e.name},A("div",{class:"parameter-about"},A("strong",{},e.name),...a===""?[]:[A("span",{class:"parameter-when"},a)],A("p",{},e.meaning),A("p",{class:"parameter-limits"},o),...n===void 0?[]:[A("p",{class:"parameter-file"},`in the file: ${n}`)],r),A("div",{class:"parameter-value"},e.live||e.may_save===!0?this.field(e,t??e.value,r):A("output",{},Jr(e.value)),A("span",{class:"parameter-unit"},e.unit),...t===void 0?[]:[this.back(e)]))}back(e){let t=A("button",{type:"button",class:"link","aria-label":`Take back ${e.name}`},`back to ${Jr(e.value)}`);return t.addEventListener("click",()=>{this.edits.drop(e.name),this.refresh(),this.edited()}),t}take(e,t){if(e.live){this.set(e.name,t);return}this.edits.set(e,t),this.refresh(),this.edited()}field(e,t,n){if(e.type==="choice"){let o=A("select",{"aria-label":e.name});for(let a of e.choices)o.append(A("option",{value:a},a));return o.value=String(t),o.addEventListener("change",()=>{o.blur(),this.take(e,o.value)}),o}if(e.type==="boolean"){let o=A("input",{type:"checkbox","aria-label":e.name});return o.checked=t===!0,o.addEventListener("change",()=>{o.blur(),this.take(e,o.checked)}),o}let s=e.type==="text",r=A("input",{"aria-label":e.name,inputmode:s?"text":"decimal",size:"8"});return r.value=s?String(t):Jr(t),r.addEventListener("change",()=>{let o=Vy(e,r.value),a="why"in o;r.setAttribute("aria-invalid",String(a)),n.textContent=a?o.why:"",a||this.take(e,o.value)}),r.addEventListener("keydown",o=>{o.key==="Enter"&&r.blur()}),r}};var vd=class{constructor(e,t){this.call=t;this.table=new _d(this.edits,e,()=>{this.count()}),this.element.append(A("div",{class:"parameters-bar"},A("div",{class:"parameters-tools"},this.table.filter,this.save,this.restore),this.said,this.question),this.table.element),this.save.addEventListener("click",()=>{this.ask("parameters_save",this.edits.wanted(this.all))}),this.restore.addEventListener("click",()=>{this.ask("parameters_restore",{})})}call;element=A("div",{class:"parameters",tabindex:"0"});save=A("button",{type:"button",class:"control",id:"parameters-save"},"Save …");restore=A("button",{type:"button",class:"control",id:"parameters-restore",hidden:""},"Undo the last save …");said=A("p",{class:"parameters-said",role:"status"});question=A("section",{class:"parameters-question",id:"parameters-question","aria-label":"Difference",hidden:""});edits=new gd;table;store;mayCommand=!1;compared=-1;busy=!1;show(e,t,n){this.store=e,this.mayCommand=t&&n,this.count(),this.table.show(e);let s=e.received["/parameter"]??0;this.mayCommand&&s>0&&s!==this.compared&&(this.compared=s,this.compare())}get all(){return this.store?.get("/parameter")?.parameters??[]}count(){let e=this.edits.names.length;Ne(this.save,e===0?"Save …":`Save … (${e})`),this.save.disabled=this.restore.disabled=!this.mayCommand||this.busy}async compare(){try{let e=await this.call("parameters_save",{check:!0,...this.edits.inForce(this.all)});this.edits.compared(e),this.restore.hidden=!e.may_restore,this.table.refresh()}catch(e){this.say(e)}}async ask(e,t){let n=await this.request(e,{...t,check:!0});if(n===void 0)return;if(n.differences.length===0){this.say(`${n.file} has these values already.`);return}let s=e==="parameters_restore",r=new Map(n.differences.map(({name:c})=>[c,!0])),o=A("button",{type:"button",class:"control",id:"parameters-write"},s?"Undo it":`Write ${n.file}`),a=A("button",{type:"button",class:"control",id:"parameters-cancel"},"Cancel");o.addEventListener("click",()=>{let c=Object.fromEntries(Object.entries(t).filter(([h])=>r.get(h)===!0));this.write(e,c)}),a.addEventListener("click",()=>{this.question.hidden=!0});let l=c=>this.difference(c,s?void 0:h=>{r.set(c.name,h),o.disabled=![...r.values()].includes(!0)});this.question.replaceChildren(A("p",{},s?`${n.file} will be as it was before:`:`In ${n.file} will change:`),A("ul",{},...n.differences.map(l)),A("div",{class:"parameters-tools"},o,a)),this.say(""),this.question.hidden=!1,o.focus()}difference({name:e,before:t,after:n},s){let r=[A("strong",{},e),A("del",{},t),A("ins",{},n)];if(s===void 0)return A("li",{},...r);let o=A("input",{type:"checkbox","aria-label":`Save ${e}`});return o.checked=!0,o.addEventListener("change",()=>{s(o.checked)}),A("li",{},A("label",{},o,...r))}async write(e,t){let n=await this.request(e,t);if(n===void 0)return;this.question.hidden=!0;for(let r of Object.keys(t))this.edits.drop(r);let s=n.differences.some(({name:r})=>this.all.find(o=>o.name===r)?.live!==!0||e==="parameters_restore");this.say(`${n.file} is saved${s?"; the running daemon keeps its values until it is started again":""}.`),await this.compare(),this.count()}async request(e,t){this.busy=!0,this.count();try{return await this.call(e,t)}catch(n){this.question.hidden=!0,this.say(n);return}finally{this.busy=!1,this.count()}}say(e){Ne(this.said,e instanceof Error?e.message:String(e))}};var xP=12,yd=class{constructor(e,t,n){this.world=e;this.yaw_rad=t;this.done=n;let s=document.createElementNS("http://www.w3.org/2000/svg","svg");s.append(this.arrow),this.element.append(s),this.element.addEventListener("pointerdown",r=>{r.isPrimary&&(this.element.setPointerCapture(r.pointerId),this.from=this.at(r),this.draw(this.from))}),this.element.addEventListener("pointermove",r=>{this.from!==void 0&&this.draw(this.at(r))}),this.element.addEventListener("pointercancel",()=>{this.from=void 0}),this.element.addEventListener("pointerup",r=>{this.finish(this.at(r))})}world;yaw_rad;done;element=A("div",{class:"placing",hidden:""});arrow=document.createElementNS("http://www.w3.org/2000/svg","line");from;show(e){this.element.hidden=!e,this.from=void 0,this.arrow.style.display="none"}at(e){let t=this.element.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}draw(e){let t=this.from??e;this.arrow.style.display="";for(let[n,s]of[["x1",t.x],["y1",t.y],["x2",e.x],["y2",e.y]])Ke(this.arrow,n,s.toFixed(1))}finish(e){let t=this.from;if(this.from=void 0,t===void 0)return;let n=this.world(t),s=this.world(e);if(n===void 0||s===void 0){this.done(void 0);return}let o=Math.hypot(e.x-t.x,e.y-t.y)>=xP?Math.atan2(s.y-n.y,s.x-n.x):this.yaw_rad();this.done({x_m:n.x,y_m:n.y,yaw_rad:o})}};var bP="uplot",wP="u-hz",SP="u-vt",MP="u-title",TP="u-wrap",EP="u-under",AP="u-over",CP="u-axis",eo="u-off",PP="u-select",RP="u-cursor-x",LP="u-cursor-y",IP="u-cursor-pt",DP="u-legend",NP="u-live",kP="u-inline",OP="u-series",UP="u-marker",Wy="u-label",FP="u-value",Hl="width",Wl="height";var Xy="bottom",ha="left",km="right",jm="#000",qy=jm+"0",Om="mousemove",$y="mousedown",Um="mouseup",Yy="mouseenter",Ky="mouseleave",Zy="dblclick",BP="resize",zP="scroll",Jy="change",Md="dppxchange",Qm="--",_a=typeof window<"u",Gm=_a?document:null,da=_a?window:null,VP=_a?navigator:null,At,xd;function Hm(){let i=devicePixelRatio;At!=i&&(At=i,xd&&Xm(Jy,xd,Hm),xd=matchMedia(`(min-resolution: ${At-.001}dppx) and (max-resolution: ${At+.001}dppx)`),to(Jy,xd,Hm),da.dispatchEvent(new CustomEvent(Md)))}function bi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Wm(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function $t(i,e,t){i.style[e]=t+"px"}function ji(i,e,t,n){let s=Gm.createElement(i);return e!=null&&bi(s,e),t?.insertBefore(s,n),s}function ki(i,e){return ji("div",i,e)}var jy=new WeakMap;function ws(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=jy.get(i);r!=o&&(i.style.transform=r,jy.set(i,r),e<0||t<0||e>n||t>s?bi(i,eo):Wm(i,eo))}var Qy=new WeakMap;function ex(i,e,t){let n=e+t,s=Qy.get(i);n!=s&&(Qy.set(i,n),i.style.background=e,i.style.borderColor=t)}var tx=new WeakMap;function nx(i,e,t,n){let s=e+""+t,r=tx.get(i);s!=r&&(tx.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var eg={passive:!0},GP={...eg,capture:!0};function to(i,e,t,n){e.addEventListener(i,t,n?GP:eg)}function Xm(i,e,t,n){e.removeEventListener(i,t,eg)}_a&&Hm();function Qi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:wi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Rx(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var Lx=i=>i!=null,Ix=i=>i!=null&&i>0,Ad=Rx(Lx),HP=Rx(Ix);function WP(i,e,t,n=0,s=!1){let r=s?HP:Ad,o=s?Ix:Lx;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ft,l??-Ft]}function Cd(i,e,t,n){let s=rx(i),r=rx(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Ks:Dx,a=s==1?wi:Oi,l=r==1?Oi:wi,c=a(o(Cn(i))),h=l(o(Cn(e))),u=fa(t,c),d=fa(t,h);return t==10&&(c<0&&(u=Bt(u,-c)),h<0&&(d=Bt(d,-h))),n||t==2?(i=u*s,e=d*r):(i=Ux(i,u),e=Pd(e,d)),[i,e]}function tg(i,e,t,n){let s=Cd(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var ng=.1,ix={mode:3,pad:ng},ql={pad:0,soft:null,mode:0},XP={min:ql,max:ql};function Td(i,e,t,n){return Rd(t)?sx(i,e,t):(ql.pad=t,ql.soft=n?0:null,ql.mode=n?3:0,sx(i,e,XP))}function Tt(i,e){return i??e}function qP(i,e,t){for(e=Tt(e,0),t=Tt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function sx(i,e,t){let n=t.min,s=t.max,r=Tt(n.pad,0),o=Tt(s.pad,0),a=Tt(n.hard,-Ft),l=Tt(s.hard,Ft),c=Tt(n.soft,Ft),h=Tt(s.soft,-Ft),u=Tt(n.mode,0),d=Tt(s.mode,0),f=e-i,g=Ks(f),y=ri(Cn(i),Cn(e)),p=Ks(y),m=Cn(p-g);(f<1e-24||m>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=Ft&&(r=0),d==2&&h!=-Ft&&(o=0)));let x=f||y||1e3,C=Ks(x),M=fa(10,wi(C)),R=x*(f==0?i==0?.1:1:r),T=Bt(Ux(i-R,M/10),24),v=i>=c&&(u==1||u==3&&T<=c||u==2&&T>=c)?c:Ft,E=ri(a,T<v&&i>=v?v:es(v,T)),z=x*(f==0?e==0?.1:1:o),k=Bt(Pd(e+z,M/10),24),N=e<=h&&(d==1||d==3&&k>=h||d==2&&k<=h)?h:-Ft,W=es(l,k>N&&e<=N?N:ri(N,k));return E==W&&E==0&&(W=100),[E,W]}var $P=new Intl.NumberFormat(_a?VP.language:"en-US"),ig=i=>$P.format(i),Si=Math,Sd=Si.PI,Cn=Si.abs,wi=Si.floor,An=Si.round,Oi=Si.ceil,es=Si.min,ri=Si.max,fa=Si.pow,rx=Si.sign,Ks=Si.log10,Dx=Si.log2,YP=(i,e=1)=>Si.sinh(i)*e,Fm=(i,e=1)=>Si.asinh(i/e),Ft=1/0;function ox(i){return(Ks((i^i>>31)-(i>>31))|0)+1}function qm(i,e,t){return es(ri(i,e),t)}function Nx(i){return typeof i=="function"}function bt(i){return Nx(i)?i:()=>i}var KP=()=>{},kx=i=>i,Ox=(i,e)=>e,ZP=i=>null,ax=i=>!0,lx=(i,e)=>i==e,JP=/\.\d*?(?=9{6,}|0{6,})/gm,no=i=>{if(Bx(i)||Tr.has(i))return i;let e=`${i}`,t=e.match(JP);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${no(s)}e${r}`}return Bt(i,n)};function jr(i,e){return no(Bt(no(i/e))*e)}function Pd(i,e){return no(Oi(no(i/e))*e)}function Ux(i,e){return no(wi(no(i/e))*e)}function Bt(i,e=0){if(Bx(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return An(n)/t}var Tr=new Map;function Fx(i){return((""+i).split(".")[1]||"").length}function Yl(i,e,t,n){let s=[],r=n.map(Fx);for(let o=e;o<t;o++){let a=Cn(o),l=Bt(fa(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Bt(h,u);s.push(d),Tr.set(d,u)}}return s}var $l={},sg=[],pa=[null,null],Mr=Array.isArray,Bx=Number.isInteger,jP=i=>i===void 0;function cx(i){return typeof i=="string"}function Rd(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function QP(i){return i!=null&&typeof i=="object"}var eR=Object.getPrototypeOf(Uint8Array),zx="__proto__";function ma(i,e=Rd){let t;if(Mr(i)){let n=i.find(s=>s!=null);if(Mr(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=ma(i[s],e)}else t=i.slice()}else if(i instanceof eR)t=i.slice();else if(e(i)){t={};for(let n in i)n!=zx&&(t[n]=ma(i[n],e))}else t=i;return t}function xn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=zx&&(Rd(i[s])?xn(i[s],ma(n[s])):i[s]=ma(n[s]))}return i}var tR=0,nR=1,iR=2;function sR(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function rR(i,e){if(lR(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return cR(o[0])||(o=aR(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:nR,f=[];for(let g=0;g<h.length;g++){let y=h[g],p=r.get(l[g]);y===null?d!=tR&&(u[p]=y,d==iR&&f.push(p)):u[p]=y}sR(u,f,s),n.push(u)}}return n}var oR=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function aR(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function lR(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function cR(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ri(1,wi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Vx=["January","February","March","April","May","June","July","August","September","October","November","December"],Gx=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Hx(i){return i.slice(0,3)}var hR=Gx.map(Hx),uR=Vx.map(Hx),dR={MMMM:Vx,MMM:uR,WWWW:Gx,WWW:hR};function Gl(i){return(i<10?"0":"")+i}function fR(i){return(i<10?"00":i<100?"0":"")+i}var pR={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Gl(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Gl(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Gl(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Gl(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Gl(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>fR(i.getMilliseconds())};function rg(i,e){e=e||dR;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?pR[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var mR=new Intl.DateTimeFormat().resolvedOptions().timeZone;function gR(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==mR?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Wx=i=>i%1==0,Ed=[1,2,2.5,5],_R=Yl(10,-32,0,Ed),Xx=Yl(10,0,32,Ed),vR=Xx.filter(Wx),Qr=_R.concat(Xx),og=`
`,qx="{YYYY}",hx=og+qx,$x="{M}/{D}",Xl=og+$x,bd=Xl+"/{YY}",Yx="{aa}",yR="{h}:{mm}",ua=yR+Yx,ux=og+ua,dx=":{ss}",Lt=null;function Kx(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?Yl(10,0,3,Ed).filter(Wx):Yl(10,-3,0,Ed)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,qx,Lt,Lt,Lt,Lt,Lt,Lt,1],[s*28,"{MMM}",hx,Lt,Lt,Lt,Lt,Lt,1],[s,$x,hx,Lt,Lt,Lt,Lt,Lt,1],[n,"{h}"+Yx,bd,Lt,Xl,Lt,Lt,Lt,1],[t,ua,bd,Lt,Xl,Lt,Lt,Lt,1],[e,dx,bd+" "+ua,Lt,Xl+" "+ua,Lt,ux,Lt,1],[i,dx+".{fff}",bd+" "+ua,Lt,Xl+" "+ua,Lt,ux,Lt,1]];function h(u){return(d,f,g,y,p,m)=>{let x=[],C=p>=o,M=p>=r&&p<o,R=u(g),T=Bt(R*i,3),v=Bm(R.getFullYear(),C?0:R.getMonth(),M||C?1:R.getDate()),E=Bt(v*i,3);if(M||C){let z=M?p/r:0,k=C?p/o:0,N=T==E?T:Bt(Bm(v.getFullYear()+k,v.getMonth()+z,1)*i,3),W=new Date(An(N/i)),H=W.getFullYear(),I=W.getMonth();for(let F=0;N<=y;F++){let q=Bm(H+k*F,I+z*F,1),V=q-u(Bt(q*i,3));N=Bt((+q+V)*i,3),N<=y&&x.push(N)}}else{let z=p>=s?s:p,k=wi(g)-wi(T),N=E+k+Pd(T-E,z);x.push(N);let W=u(N),H=W.getHours()+W.getMinutes()/t+W.getSeconds()/n,I=p/n,F=d.axes[f]._space,q=m/F;for(;N=Bt(N+p,i==1?0:3),!(N>y);)if(I>1){let V=wi(Bt(H+I,6))%24,Q=u(N).getHours()-V;Q>1&&(Q=-1),N-=Q*n,H=(H+I)%24;let ie=x[x.length-1];Bt((N-ie)/p,3)*q>=.7&&x.push(N)}else x.push(N)}return x}}return[l,c,h]}var[xR,bR,wR]=Kx(1),[SR,MR,TR]=Kx(.001);Yl(2,-53,53,[1]);function fx(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function px(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,u,d,f;return n.map(g=>{let y=i(g),p=y.getFullYear(),m=y.getMonth(),x=y.getDate(),C=y.getHours(),M=y.getMinutes(),R=y.getSeconds(),T=p!=l&&a[2]||m!=c&&a[3]||x!=h&&a[4]||C!=u&&a[5]||M!=d&&a[6]||R!=f&&a[7]||a[1];return l=p,c=m,h=x,u=C,d=M,f=R,T(y)})}}function ER(i,e){let t=rg(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Bm(i,e,t){return new Date(i,e,t)}function mx(i,e){return e(i)}var AR="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function gx(i,e){return(t,n,s,r)=>r==null?Qm:e(i(n))}function CR(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function PR(i,e){return i.series[e].fill(i,e)}var RR={show:!0,live:!0,isolate:!1,mount:KP,markers:{show:!0,width:2,stroke:CR,fill:PR,dash:"solid"},idx:null,idxs:null,values:[]};function LR(i,e){let t=i.cursor.points,n=ki(),s=t.size(i,e);$t(n,Hl,s),$t(n,Wl,s);let r=s/-2;$t(n,"marginLeft",r),$t(n,"marginTop",r);let o=t.width(i,e,s);return o&&$t(n,"borderWidth",o),n}function IR(i,e){let t=i.series[e].points;return t._fill||t._stroke}function DR(i,e){let t=i.series[e].points;return t._stroke||t._fill}function NR(i,e){return i.series[e].points.size}var zm=[0,0];function kR(i,e,t){return zm[0]=e,zm[1]=t,zm}function wd(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Vm(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var OR={show:!0,x:!0,y:!0,lock:!1,move:kR,points:{one:!1,show:LR,size:NR,width:0,stroke:DR,fill:IR},bind:{mousedown:wd,mouseup:wd,click:wd,dblclick:wd,mousemove:Vm,mouseleave:Vm,mouseenter:Vm},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Zx={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ag=xn({},Zx,{filter:Ox}),Jx=xn({},ag,{size:10}),jx=xn({},Zx,{show:!1}),lg='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Qx="bold "+lg,eb=1.5,_x={show:!0,scale:"x",stroke:jm,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Qx,side:2,grid:ag,ticks:Jx,border:jx,font:lg,lineGap:eb,rotate:0},UR="Value",FR="Time",vx={show:!0,scale:"x",auto:!1,sorted:1,min:Ft,max:-Ft,idxs:[]};function BR(i,e,t,n,s){return e.map(r=>r==null?"":ig(r))}function zR(i,e,t,n,s,r,o){let a=[],l=Tr.get(s)||0;t=o?t:Bt(Pd(t,s),l);for(let c=t;c<=n;c=Bt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function $m(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?Ks:Dx,h=wi(c(t));s=fa(l,h),l==10&&(s=Qr[Qi(s,Qr)]);let u=t,d=s*l;l==10&&(d=Qr[Qi(d,Qr)]);do a.push(u),u=u+s,l==10&&!Tr.has(u)&&(u=Bt(u,Tr.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Qr[Qi(d,Qr)]));while(u<=n);return a}function VR(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?$m(i,e,ri(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?$m(i,e,ri(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var tb=/./,GR=/[12357]/,HR=/[125]/,yx=/1/,Ym=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function WR(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?tb:l(7,o)-h>=c?GR:l(5,o)-h>=c?HR:yx;if(u==yx){let d=Cn(l(1,o)-h);if(d<c)return Ym(e.slice().reverse(),a.distr,u,Oi(c/d)).reverse()}return Ym(e,a.distr,u,1)}function XR(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=Cn(l(1,o)-l(2,o));return c<a?Ym(e.slice().reverse(),3,tb,Oi(a/c)).reverse():e}function qR(i,e,t,n){return n==null?Qm:e==null?"":ig(e)}var xx={show:!0,scale:"y",stroke:jm,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Qx,side:3,grid:ag,ticks:Jx,border:jx,font:lg,lineGap:eb,rotate:0};function $R(i,e){let t=3+(i||1)*2;return Bt(t*e,3)}function YR(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=Cn(o-r),l=i.series[e],c=a/(l.points.space*At);return n[1]-n[0]<=c}var bx={scale:null,auto:!0,sorted:0,min:Ft,max:-Ft},nb=(i,e,t,n,s)=>s,wx={show:!0,auto:!0,sorted:0,gaps:nb,alpha:1,facets:[xn({},bx,{scale:"x"}),xn({},bx,{scale:"y"})]},Sx={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:nb,alpha:1,points:{show:YR,filter:null},values:null,min:Ft,max:-Ft,idxs:[],path:null,clip:null};function KR(i,e,t,n,s){return t/10}var ib={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},ZR=xn({},ib,{time:!1,ori:1}),Mx={};function sb(i,e){let t=Mx[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Mx[i]=t)),t}var ga=1,Km=2;function io(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,y=a.height,p=i.valToPosH,m=i.valToPosV;return h.ori==0?t(s,l,c,h,u,p,m,d,f,g,y,Id,va,Nd,ob,lb):t(s,l,c,h,u,m,p,f,d,y,g,Dd,ya,ug,ab,cb)}function cg(i,e){let t=0,n=0,s=Tt(i.bands,sg);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function JR(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Zs(i,e,t,n,s,r){return io(i,e,(o,a,l,c,h,u,d,f,g,y,p)=>{let m=o.pxRound,x=c.dir*(c.ori==0?1:-1),C=c.ori==0?va:ya,M,R;x==1?(M=t,R=n):(M=n,R=t);let T=m(u(a[M],c,y,f)),v=m(d(l[M],h,p,g)),E=m(u(a[R],c,y,f)),z=m(d(r==1?h.max:h.min,h,p,g)),k=new Path2D(s);return C(k,E,z),C(k,T,z),C(k,T,v),k})}function Ld(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Nd:ug,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function jR(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function hg(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),g=d==u?f:r(i[d]),y=u-s;f=o<=0&&y>=0&&y<l?r(i[y]):f;let m=d+s;g=o>=0&&m>=0&&m<l?r(i[m]):g,g>=f&&a.push([f,g])}return a}function Tx(i){return i==0?kx:i==1?An:e=>jr(e,i)}function rb(i){let e=i==0?Id:Dd,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=es(c,a/2,l/2),h=es(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Id=(i,e,t)=>{i.moveTo(e,t)},Dd=(i,e,t)=>{i.moveTo(t,e)},va=(i,e,t)=>{i.lineTo(e,t)},ya=(i,e,t)=>{i.lineTo(t,e)},Nd=rb(0),ug=rb(1),ob=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},ab=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},lb=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},cb=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function hb(i){return(e,t,n,s,r)=>io(e,t,(o,a,l,c,h,u,d,f,g,y,p)=>{let{pxRound:m,points:x}=o,C,M;c.ori==0?(C=Id,M=ob):(C=Dd,M=ab);let R=Bt(x.width*At,3),T=(x.size-x.width)/2*At,v=Bt(T*2,3),E=new Path2D,z=new Path2D,{left:k,top:N,width:W,height:H}=e.bbox;Nd(z,k-v,N-v,W+v*2,H+v*2);let I=F=>{if(l[F]!=null){let q=m(u(a[F],c,y,f)),V=m(d(l[F],h,p,g));C(E,q+T,V),M(E,q,V,T,0,Sd*2)}};if(r)r.forEach(I);else for(let F=n;F<=s;F++)I(F);return{stroke:R>0?E:null,fill:E,clip:z,flags:ga|Km}})}function ub(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var QR=ub(va),e2=ub(ya);function db(i){let e=Tt(i?.alignGaps,0);return(t,n,s,r)=>io(t,n,(o,a,l,c,h,u,d,f,g,y,p)=>{[s,r]=Ad(l,s,r);let m=o.pxRound,x=H=>m(u(H,c,y,f)),C=H=>m(d(H,h,p,g)),M,R;c.ori==0?(M=va,R=QR):(M=ya,R=e2);let T=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ga},E=v.stroke,z=!1;if(r-s>=y*4){let H=ue=>t.posToVal(ue,c.key,!0),I=null,F=null,q,V,le,Z=x(a[T==1?s:r]),Q=x(a[s]),ie=x(a[r]),de=H(T==1?Q+1:ie-1);for(let ue=T==1?s:r;ue>=s&&ue<=r;ue+=T){let ee=a[ue],ge=(T==1?ee<de:ee>de)?Z:x(ee),ve=l[ue];ge==Z?ve!=null?(V=ve,I==null?(M(E,ge,C(V)),q=I=F=V):V<I?I=V:V>F&&(F=V)):ve===null&&(z=!0):(I!=null&&R(E,Z,C(I),C(F),C(q),C(V)),ve!=null?(V=ve,M(E,ge,C(V)),I=F=q=V):(I=F=null,ve===null&&(z=!0)),Z=ge,de=H(Z+T))}I!=null&&I!=F&&le!=Z&&R(E,Z,C(I),C(F),C(q),C(V))}else for(let H=T==1?s:r;H>=s&&H<=r;H+=T){let I=l[H];I===null?z=!0:I!=null&&M(E,x(a[H]),C(I))}let[N,W]=cg(t,n);if(o.fill!=null||N!=0){let H=v.fill=new Path2D(E),I=o.fillTo(t,n,o.min,o.max,N),F=C(I),q=x(a[s]),V=x(a[r]);T==-1&&([V,q]=[q,V]),M(H,V,F),M(H,q,F)}if(!o.spanGaps){let H=[];z&&H.push(...hg(a,l,s,r,T,x,e)),v.gaps=H=o.gaps(t,n,s,r,H),v.clip=Ld(H,c.ori,f,g,y,p)}return W!=0&&(v.band=W==2?[Zs(t,n,s,r,E,-1),Zs(t,n,s,r,E,1)]:Zs(t,n,s,r,E,W)),v})}function t2(i){let e=Tt(i.align,1),t=Tt(i.ascDesc,!1),n=Tt(i.alignGaps,0),s=Tt(i.extend,!1);return(r,o,a,l)=>io(r,o,(c,h,u,d,f,g,y,p,m,x,C)=>{[a,l]=Ad(u,a,l);let M=c.pxRound,{left:R,width:T}=r.bbox,v=Q=>M(g(Q,d,x,p)),E=Q=>M(y(Q,f,C,m)),z=d.ori==0?va:ya,k={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ga},N=k.stroke,W=d.dir*(d.ori==0?1:-1),H=E(u[W==1?a:l]),I=v(h[W==1?a:l]),F=I,q=I;s&&e==-1&&(q=R,z(N,q,H)),z(N,I,H);for(let Q=W==1?a:l;Q>=a&&Q<=l;Q+=W){let ie=u[Q];if(ie==null)continue;let de=v(h[Q]),ue=E(ie);e==1?z(N,de,H):z(N,F,ue),z(N,de,ue),H=ue,F=de}let V=F;s&&e==1&&(V=R+T,z(N,V,H));let[le,Z]=cg(r,o);if(c.fill!=null||le!=0){let Q=k.fill=new Path2D(N),ie=c.fillTo(r,o,c.min,c.max,le),de=E(ie);z(Q,V,de),z(Q,q,de)}if(!c.spanGaps){let Q=[];Q.push(...hg(h,u,a,l,W,v,n));let ie=c.width*At/2,de=t||e==1?ie:-ie,ue=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=de,ee[1]+=ue}),k.gaps=Q=c.gaps(r,o,a,l,Q),k.clip=Ld(Q,d.ori,p,m,x,C)}return Z!=0&&(k.band=Z==2?[Zs(r,o,a,l,N,-1),Zs(r,o,a,l,N,1)]:Zs(r,o,a,l,N,Z)),k})}function Ex(i,e,t,n,s,r,o=Ft){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=Cn(i[l]-i[a]);h<c&&(c=h,o=Cn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function n2(i){i=i||$l;let e=Tt(i.size,[.6,Ft,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=bt(s),o=1-e[0],a=Tt(e[1],Ft),l=Tt(e[2],1),c=Tt(i.disp,$l),h=Tt(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,g,y,p)=>io(f,g,(m,x,C,M,R,T,v,E,z,k,N)=>{let W=m.pxRound,H=t,I=n*At,F=a*At,q=l*At,V,le;M.ori==0?[V,le]=r(f,g):[le,V]=r(f,g);let Z=M.dir*(M.ori==0?1:-1),Q=M.ori==0?Nd:ug,ie=M.ori==0?h:(Pe,Ye,lt,Me,Ut,He,qe)=>{h(Pe,Ye,lt,Ut,Me,qe,He)},de=Tt(f.bands,sg).find(Pe=>Pe.series[0]==g),ue=de!=null?de.dir:0,ee=m.fillTo(f,g,m.min,m.max,ue),me=W(v(ee,R,N,z)),ge,ve,_e,Ge=k,Ze=W(m.width*At),Ue=!1,st=null,ct=null,rt=null,Yt=null;u!=null&&(Ze==0||d!=null)&&(Ue=!0,st=u.values(f,g,y,p),ct=new Map,new Set(st).forEach(Pe=>{Pe!=null&&ct.set(Pe,new Path2D)}),Ze>0&&(rt=d.values(f,g,y,p),Yt=new Map,new Set(rt).forEach(Pe=>{Pe!=null&&Yt.set(Pe,new Path2D)})));let{x0:zt,size:dn}=c;if(zt!=null&&dn!=null){H=1,x=zt.values(f,g,y,p),zt.unit==2&&(x=x.map(lt=>f.posToVal(E+lt*k,M.key,!0)));let Pe=dn.values(f,g,y,p);dn.unit==2?ve=Pe[0]*k:ve=T(Pe[0],M,k,E)-T(0,M,k,E),Ge=Ex(x,C,T,M,k,E,Ge),_e=Ge-ve+I}else Ge=Ex(x,C,T,M,k,E,Ge),_e=Ge*o+I,ve=Ge-_e;_e<1&&(_e=0),Ze>=ve/2&&(Ze=0),_e<5&&(W=kx);let kt=_e>0,Rn=Ge-_e-(kt?Ze:0);ve=W(qm(Rn,q,F)),ge=(H==0?ve/2:H==Z?0:ve)-H*Z*((H==0?I/2:0)+(kt?Ze/2:0));let wt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Sn=Ue?null:new Path2D,nn=null;if(de!=null)nn=f.data[de.series[1]];else{let{y0:Pe,y1:Ye}=c;Pe!=null&&Ye!=null&&(C=Ye.values(f,g,y,p),nn=Pe.values(f,g,y,p))}let fn=V*ve,U=le*ve;for(let Pe=Z==1?y:p;Pe>=y&&Pe<=p;Pe+=Z){let Ye=C[Pe];if(Ye==null)continue;if(nn!=null){let X=nn[Pe]??0;if(Ye-X==0)continue;me=v(X,R,N,z)}let lt=M.distr!=2||c!=null?x[Pe]:Pe,Me=T(lt,M,k,E),Ut=v(Tt(Ye,ee),R,N,z),He=W(Me-ge),qe=W(ri(Ut,me)),P=W(es(Ut,me)),b=qe-P;if(Ye!=null){let X=Ye<0?U:fn,he=Ye<0?fn:U;Ue?(Ze>0&&rt[Pe]!=null&&Q(Yt.get(rt[Pe]),He,P+wi(Ze/2),ve,ri(0,b-Ze),X,he),st[Pe]!=null&&Q(ct.get(st[Pe]),He,P+wi(Ze/2),ve,ri(0,b-Ze),X,he)):Q(Sn,He,P+wi(Ze/2),ve,ri(0,b-Ze),X,he),ie(f,g,Pe,He-Ze/2,P,ve+Ze,b)}}return Ze>0?wt.stroke=Ue?Yt:Sn:Ue||(wt._fill=m.width==0?m._fill:m._stroke??m._fill,wt.width=0),wt.fill=Ue?ct:Sn,wt})}function i2(i,e){let t=Tt(e?.alignGaps,0);return(n,s,r,o)=>io(n,s,(a,l,c,h,u,d,f,g,y,p,m)=>{[r,o]=Ad(c,r,o);let x=a.pxRound,C=V=>x(d(V,h,p,g)),M=V=>x(f(V,u,m,y)),R,T,v;h.ori==0?(R=Id,v=va,T=lb):(R=Dd,v=ya,T=cb);let E=h.dir*(h.ori==0?1:-1),z=C(l[E==1?r:o]),k=z,N=[],W=[];for(let V=E==1?r:o;V>=r&&V<=o;V+=E)if(c[V]!=null){let Z=l[V],Q=C(Z);N.push(k=Q),W.push(M(c[V]))}let H={stroke:i(N,W,R,v,T,x),fill:null,clip:null,band:null,gaps:null,flags:ga},I=H.stroke,[F,q]=cg(n,s);if(a.fill!=null||F!=0){let V=H.fill=new Path2D(I),le=a.fillTo(n,s,a.min,a.max,F),Z=M(le);v(V,k,Z),v(V,z,Z)}if(!a.spanGaps){let V=[];V.push(...hg(l,c,r,o,E,C,t)),H.gaps=V=a.gaps(n,s,r,o,V),H.clip=Ld(V,h.ori,g,y,p,m)}return q!=0&&(H.band=q==2?[Zs(n,s,r,o,I,-1),Zs(n,s,r,o,I,1)]:Zs(n,s,r,o,I,q)),H})}function s2(i){return i2(r2,i)}function r2(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var Zm=new Set;function Ax(){for(let i of Zm)i.syncRect(!0)}_a&&(to(BP,da,Ax),to(zP,da,Ax,!0),to(Md,da,()=>{bn.pxRatio=At}));var o2=db(),a2=hb();function Cx(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Jm(r,o,e,t))}function l2(i,e){return i.map((t,n)=>n==0?{}:xn({},e,t))}function Jm(i,e,t,n){return xn({},e==0?t:n,i)}function fb(i,e,t){return e==null?pa:[e,t]}var c2=fb;function h2(i,e,t){return e==null?pa:Td(e,t,ng,!0)}function pb(i,e,t,n){return e==null?pa:Cd(e,t,i.scales[n].log,!1)}var u2=pb;function mb(i,e,t,n){return e==null?pa:tg(e,t,i.scales[n].log,!1)}var d2=mb;function f2(i,e,t,n,s){let r=ri(ox(i),ox(e)),o=e-i,a=Qi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Tr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Px(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=An((t=+s)*At))+"px"),[i,e,t]}function p2(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Bt(e[2]*At,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function bn(i,e,t){let n={mode:Tt(i.mode,1)},s=n.mode;function r(_,w,L,D){let G=w.valToPct(_);return D+L*(w.dir==-1?1-G:G)}function o(_,w,L,D){let G=w.valToPct(_);return D+L*(w.dir==-1?G:1-G)}function a(_,w,L,D){return w.ori==0?r(_,w,L,D):o(_,w,L,D)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=ki(bP);if(i.id!=null&&(c.id=i.id),bi(c,i.class),i.title){let _=ki(MP,c);_.textContent=i.title}let h=ji("canvas"),u=n.ctx=h.getContext("2d"),d=ki(TP,c);to("click",d,_=>{_.target===g&&(Gt!=go||Kt!=_o)&&zn.click(n,_)},!0);let f=n.under=ki(EP,d);d.appendChild(h);let g=n.over=ki(AP,d);i=ma(i);let y=+Tt(i.pxAlign,1),p=Tx(y);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let m=i.ms||.001,x=n.series=s==1?Cx(i.series||[],vx,Sx,!1):l2(i.series||[null],wx),C=n.axes=Cx(i.axes||[],_x,xx,!0),M=n.scales={},R=n.bands=i.bands||[];R.forEach(_=>{_.fill=bt(_.fill||null),_.dir=Tt(_.dir,-1)});let T=s==2?x[1].facets[0].scale:x[0].scale,v={axes:Ls,series:gt},E=(i.drawOrder||["axes","series"]).map(_=>v[_]);function z(_){let w=_.distr==3?L=>Ks(L>0?L:_.clamp(n,L,_.min,_.max,_.key)):_.distr==4?L=>Fm(L,_.asinh):_.distr==100?L=>_.fwd(L):L=>L;return L=>{let D=w(L),{_min:G,_max:J}=_,ae=J-G;return(D-G)/ae}}function k(_){let w=M[_];if(w==null){let L=(i.scales||$l)[_]||$l;if(L.from!=null){k(L.from);let D=xn({},M[L.from],L,{key:_});D.valToPct=z(D),M[_]=D}else{w=M[_]=xn({},_==T?ib:ZR,L),w.key=_;let D=w.time,G=w.range,J=Mr(G);if((_!=T||s==2&&!D)&&(J&&(G[0]==null||G[1]==null)&&(G={min:G[0]==null?ix:{mode:1,hard:G[0],soft:G[0]},max:G[1]==null?ix:{mode:1,hard:G[1],soft:G[1]}},J=!1),!J&&Rd(G))){let ae=G;G=(fe,we,De)=>we==null?pa:Td(we,De,ae)}w.range=bt(G||(D?c2:_==T?w.distr==3?u2:w.distr==4?d2:fb:w.distr==3?pb:w.distr==4?mb:h2)),w.auto=bt(J?!1:w.auto),w.clamp=bt(w.clamp||KR),w._min=w._max=null,w.valToPct=z(w)}}}k("x"),k("y"),s==1&&x.forEach(_=>{k(_.scale)}),C.forEach(_=>{k(_.scale)});for(let _ in i.scales)k(_);let N=M[T],W=N.distr,H,I;N.ori==0?(bi(c,wP),H=r,I=o):(bi(c,SP),H=o,I=r);let F={};for(let _ in M){let w=M[_];(w.min!=null||w.max!=null)&&(F[_]={min:w.min,max:w.max},w.min=w.max=null)}let q=i.tzDate||(_=>new Date(An(_/m))),V=i.fmtDate||rg,le=m==1?wR(q):TR(q),Z=px(q,fx(m==1?bR:MR,V)),Q=gx(q,mx(AR,V)),ie=[],de=n.legend=xn({},RR,i.legend),ue=n.cursor=xn({},OR,{drag:{y:s==2}},i.cursor),ee=de.show,me=ue.show,ge=de.markers;de.idxs=ie,ge.width=bt(ge.width),ge.dash=bt(ge.dash),ge.stroke=bt(ge.stroke),ge.fill=bt(ge.fill);let ve,_e,Ge,Ze=[],Ue=[],st,ct=!1,rt={};if(de.live){let _=x[1]?x[1].values:null;ct=_!=null,st=ct?_(n,1,0):{_:0};for(let w in st)rt[w]=Qm}if(ee)if(ve=ji("table",DP,c),Ge=ji("tbody",null,ve),de.mount(n,ve),ct){_e=ji("thead",null,ve,Ge);let _=ji("tr",null,_e);ji("th",null,_);for(var Yt in st)ji("th",Wy,_).textContent=Yt}else bi(ve,kP),de.live&&bi(ve,NP);let zt={show:!0},dn={show:!1};function kt(_,w){if(w==0&&(ct||!de.live||s==2))return pa;let L=[],D=ji("tr",OP,Ge,Ge.childNodes[w]);bi(D,_.class),_.show||bi(D,eo);let G=ji("th",null,D);if(ge.show){let fe=ki(UP,G);if(w>0){let we=ge.width(n,w);we&&(fe.style.border=we+"px "+ge.dash(n,w)+" "+ge.stroke(n,w)),fe.style.background=ge.fill(n,w)}}let J=ki(Wy,G);_.label instanceof HTMLElement?J.appendChild(_.label):J.textContent=_.label,w>0&&(ge.show||(J.style.color=_.width>0?ge.stroke(n,w):ge.fill(n,w)),wt("click",G,fe=>{if(ue._lock)return;je(fe);let we=x.indexOf(_);if((fe.ctrlKey||fe.metaKey)!=de.isolate){let De=x.some((ke,Fe)=>Fe>0&&Fe!=we&&ke.show);x.forEach((ke,Fe)=>{Fe>0&&os(Fe,De?Fe==we?zt:dn:zt,!0,_n.setSeries)})}else os(we,{show:!_.show},!0,_n.setSeries)},!1),Qe&&wt(Yy,G,fe=>{ue._lock||(je(fe),os(x.indexOf(_),yo,!0,_n.setSeries))},!1));for(var ae in st){let fe=ji("td",FP,D);fe.textContent="--",L.push(fe)}return[D,L]}let Rn=new Map;function wt(_,w,L,D=!0){let G=Rn.get(w)||{},J=ue.bind[_](n,w,L,D);J&&(to(_,w,G[_]=J),Rn.set(w,G))}function Sn(_,w,L){let D=Rn.get(w)||{};for(let G in D)(_==null||G==_)&&(Xm(G,w,D[G]),delete D[G]);_==null&&Rn.delete(w)}let nn=0,fn=0,U=0,Pe=0,Ye=0,lt=0,Me=Ye,Ut=lt,He=U,qe=Pe,P=0,b=0,X=0,he=0;n.bbox={};let oe=!1,xe=!1,be=!1,te=!1,se=!1,pe=!1;function O(_,w,L){(L||_!=n.width||w!=n.height)&&re(_,w),dt(!1),be=!0,xe=!0,Wn()}function re(_,w){n.width=nn=U=_,n.height=fn=Pe=w,Ye=lt=0,Se(),We();let L=n.bbox;P=L.left=jr(Ye*At,.5),b=L.top=jr(lt*At,.5),X=L.width=jr(U*At,.5),he=L.height=jr(Pe*At,.5)}let ne=3;function Te(){let _=!1,w=0;for(;!_;){w++;let L=fo(w),D=rs(w);_=w==ne||L&&D,_||(re(n.width,n.height),xe=!0)}}function ye({width:_,height:w}){O(_,w)}n.setSize=ye;function Se(){let _=!1,w=!1,L=!1,D=!1;C.forEach((G,J)=>{if(G.show&&G._show){let{side:ae,_size:fe}=G,we=ae%2,De=G.label!=null?G.labelSize:0,ke=fe+De;ke>0&&(we?(U-=ke,ae==3?(Ye+=ke,D=!0):L=!0):(Pe-=ke,ae==0?(lt+=ke,_=!0):w=!0))}}),is[0]=_,is[1]=L,is[2]=w,is[3]=D,U-=Ui[1]+Ui[3],Ye+=Ui[3],Pe-=Ui[2]+Ui[0],lt+=Ui[0]}function We(){let _=Ye+U,w=lt+Pe,L=Ye,D=lt;function G(J,ae){switch(J){case 1:return _+=ae,_-ae;case 2:return w+=ae,w-ae;case 3:return L-=ae,L+ae;case 0:return D-=ae,D+ae}}C.forEach((J,ae)=>{if(J.show&&J._show){let fe=J.side;J._pos=G(fe,J._size),J.label!=null&&(J._lpos=G(fe,J.labelSize))}})}if(ue.dataIdx==null){let _=ue.hover,w=_.skip=new Set(_.skip??[]);w.add(void 0);let L=_.prox=bt(_.prox),D=_.bias??=0;ue.dataIdx=(G,J,ae,fe)=>{if(J==0)return ae;let we=ae,De=L(G,J,ae,fe)??Ft,ke=De>=0&&De<Ft,Fe=N.ori==0?U:Pe,ot=ue.left,Et=e[0],Mt=e[J];if(w.has(Mt[ae])){we=null;let vt=null,Je=null,Xe;if(D==0||D==-1)for(Xe=ae;vt==null&&Xe-- >0;)w.has(Mt[Xe])||(vt=Xe);if(D==0||D==1)for(Xe=ae;Je==null&&Xe++<Mt.length;)w.has(Mt[Xe])||(Je=Xe);if(vt!=null||Je!=null)if(ke){let Wt=vt==null?-1/0:H(Et[vt],N,Fe,0),on=Je==null?1/0:H(Et[Je],N,Fe,0),Nn=ot-Wt,Ot=on-ot;Nn<=Ot?Nn<=De&&(we=vt):Ot<=De&&(we=Je)}else we=Je==null?vt:vt==null?Je:ae-vt<=Je-ae?vt:Je}else ke&&Cn(ot-H(Et[ae],N,Fe,0))>De&&(we=null);return we}}let je=_=>{ue.event=_};ue.idxs=ie,ue._lock=!1;let ce=ue.points;ce.show=bt(ce.show),ce.size=bt(ce.size),ce.stroke=bt(ce.stroke),ce.width=bt(ce.width),ce.fill=bt(ce.fill);let Be=n.focus=xn({},i.focus||{alpha:.3},ue.focus),Qe=Be.prox>=0,Ce=Qe&&ce.one,ht=[],Vt=[],Yn=[];function Ea(_,w){let L=ce.show(n,w);if(L instanceof HTMLElement)return bi(L,IP),bi(L,_.class),ws(L,-10,-10,U,Pe),g.insertBefore(L,ht[w]),L}function co(_,w){if(s==1||w>0){let L=s==1&&M[_.scale].time,D=_.value;_.value=L?cx(D)?gx(q,mx(D,V)):D||Q:D||qR,_.label=_.label||(L?FR:UR)}if(Ce||w>0){_.width=_.width==null?1:_.width,_.paths=_.paths||o2||ZP,_.fillTo=bt(_.fillTo||JR),_.pxAlign=+Tt(_.pxAlign,y),_.pxRound=Tx(_.pxAlign),_.stroke=bt(_.stroke||null),_.fill=bt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let L=$R(ri(1,_.width),1),D=_.points=xn({},{size:L,width:ri(1,L*.2),stroke:_.stroke,space:L*2,paths:a2,_stroke:null,_fill:null},_.points);D.show=bt(D.show),D.filter=bt(D.filter),D.fill=bt(D.fill),D.stroke=bt(D.stroke),D.paths=bt(D.paths),D.pxAlign=_.pxAlign}if(ee){let L=kt(_,w);Ze.splice(w,0,L[0]),Ue.splice(w,0,L[1]),de.values.push(null)}if(me){ie.splice(w,0,null);let L=null;Ce?w==0&&(L=Ea(_,w)):w>0&&(L=Ea(_,w)),ht.splice(w,0,L),Vt.splice(w,0,0),Yn.splice(w,0,0)}Dn("addSeries",w)}function mf(_,w){w=w??x.length,_=s==1?Jm(_,w,vx,Sx):Jm(_,w,{},wx),x.splice(w,0,_),co(x[w],w)}n.addSeries=mf;function sc(_){if(x.splice(_,1),ee){de.values.splice(_,1),Ue.splice(_,1);let w=Ze.splice(_,1)[0];Sn(null,w.firstChild),w.remove()}me&&(ie.splice(_,1),ht.splice(_,1)[0].remove(),Vt.splice(_,1),Yn.splice(_,1)),Dn("delSeries",_)}n.delSeries=sc;let is=[!1,!1,!1,!1];function Cs(_,w){if(_._show=_.show,_.show){let L=_.side%2,D=M[_.scale];D==null&&(_.scale=L?x[1].scale:T,D=M[_.scale]);let G=D.time;_.size=bt(_.size),_.space=bt(_.space),_.rotate=bt(_.rotate),Mr(_.incrs)&&_.incrs.forEach(ae=>{!Tr.has(ae)&&Tr.set(ae,Fx(ae))}),_.incrs=bt(_.incrs||(D.distr==2?vR:G?m==1?xR:SR:Qr)),_.splits=bt(_.splits||(G&&D.distr==1?le:D.distr==3?$m:D.distr==4?VR:zR)),_.stroke=bt(_.stroke),_.grid.stroke=bt(_.grid.stroke),_.ticks.stroke=bt(_.ticks.stroke),_.border.stroke=bt(_.border.stroke);let J=_.values;_.values=Mr(J)&&!Mr(J[0])?bt(J):G?Mr(J)?px(q,fx(J,V)):cx(J)?ER(q,J):J||Z:J||BR,_.filter=bt(_.filter||(D.distr>=3&&D.log==10?WR:D.distr==3&&D.log==2?XR:Ox)),_.font=Px(_.font),_.labelFont=Px(_.labelFont),_._size=_.size(n,null,w,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(is[w]=!0,_._el=ki(CP,d))}}function Ps(_,w,L,D){let[G,J,ae,fe]=L,we=w%2,De=0;return we==0&&(fe||J)&&(De=w==0&&!G||w==2&&!ae?An(_x.size/3):0),we==1&&(G||ae)&&(De=w==1&&!J||w==3&&!fe?An(xx.size/2):0),De}let Aa=n.padding=(i.padding||[Ps,Ps,Ps,Ps]).map(_=>bt(Tt(_,Ps))),Ui=n._padding=Aa.map((_,w)=>_(n,w,is,0)),sn,cn=null,hn=null,ss=s==1?x[0].idxs:null,di=null,js=!1;function Ca(_,w){if(e=_??[],n.data=n._data=e,s==2){sn=0;for(let L=1;L<x.length;L++)sn+=e[L][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),di=e[0],sn=di.length;let L=e;if(W==2){L=e.slice();let D=L[0]=Array(sn);for(let G=0;G<sn;G++)D[G]=G}n._data=e=L}if(dt(!0),Dn("setData"),W==2&&(be=!0),w!==!1){let L=N;L.auto(n,js)?Pa():tr(T,L.min,L.max),te=te||ue.left>=0,pe=!0,Wn()}}n.setData=Ca;function Pa(){js=!0;let _,w;s==1&&(sn>0?(cn=ss[0]=0,hn=ss[1]=sn-1,_=e[0][cn],w=e[0][hn],W==2?(_=cn,w=hn):_==w&&(W==3?[_,w]=Cd(_,_,N.log,!1):W==4?[_,w]=tg(_,_,N.log,!1):N.time?w=_+An(86400/m):[_,w]=Td(_,w,ng,!0))):(cn=ss[0]=_=null,hn=ss[1]=w=null)),tr(T,_,w)}let ho,Qs,uo,S,B,j,Y,K,Ee,Re;function Ae(_,w,L,D,G,J){_??=qy,L??=sg,D??="butt",G??=qy,J??="round",_!=ho&&(u.strokeStyle=ho=_),G!=Qs&&(u.fillStyle=Qs=G),w!=uo&&(u.lineWidth=uo=w),J!=B&&(u.lineJoin=B=J),D!=j&&(u.lineCap=j=D),L!=S&&u.setLineDash(S=L)}function Le(_,w,L,D){w!=Qs&&(u.fillStyle=Qs=w),_!=Y&&(u.font=Y=_),L!=K&&(u.textAlign=K=L),D!=Ee&&(u.textBaseline=Ee=D)}function Ve(_,w,L,D,G=0){if(D.length>0&&_.auto(n,js)&&(w==null||w.min==null)){let J=Tt(cn,0),ae=Tt(hn,D.length-1),fe=L.min==null?WP(D,J,ae,G,_.distr==3):[L.min,L.max];_.min=es(_.min,L.min=fe[0]),_.max=ri(_.max,L.max=fe[1])}}let tt={min:null,max:null};function mt(){for(let D in M){let G=M[D];F[D]==null&&(G.min==null||F[T]!=null&&G.auto(n,js))&&(F[D]=tt)}for(let D in M){let G=M[D];F[D]==null&&G.from!=null&&F[G.from]!=null&&(F[D]=tt)}F[T]!=null&&dt(!0);let _={};for(let D in F){let G=F[D];if(G!=null){let J=_[D]=ma(M[D],QP);if(G.min!=null)xn(J,G);else if(D!=T||s==2)if(sn==0&&J.from==null){let ae=J.range(n,null,null,D);J.min=ae[0],J.max=ae[1]}else J.min=Ft,J.max=-Ft}}if(sn>0){x.forEach((D,G)=>{if(s==1){let J=D.scale,ae=F[J];if(ae==null)return;let fe=_[J];if(G==0){let we=fe.range(n,fe.min,fe.max,J);fe.min=we[0],fe.max=we[1],cn=Qi(fe.min,e[0]),hn=Qi(fe.max,e[0]),hn-cn>1&&(e[0][cn]<fe.min&&cn++,e[0][hn]>fe.max&&hn--),D.min=di[cn],D.max=di[hn]}else D.show&&D.auto&&Ve(fe,ae,D,e[G],D.sorted);D.idxs[0]=cn,D.idxs[1]=hn}else if(G>0&&D.show&&D.auto){let[J,ae]=D.facets,fe=J.scale,we=ae.scale,[De,ke]=e[G],Fe=_[fe],ot=_[we];Fe!=null&&Ve(Fe,F[fe],J,De,J.sorted),ot!=null&&Ve(ot,F[we],ae,ke,ae.sorted),D.min=ae.min,D.max=ae.max}});for(let D in _){let G=_[D],J=F[D];if(G.from==null&&(J==null||J.min==null)){let ae=G.range(n,G.min==Ft?null:G.min,G.max==-Ft?null:G.max,D);G.min=ae[0],G.max=ae[1]}}}for(let D in _){let G=_[D];if(G.from!=null){let J=_[G.from];if(J.min==null)G.min=G.max=null;else{let ae=G.range(n,J.min,J.max,D);G.min=ae[0],G.max=ae[1]}}}let w={},L=!1;for(let D in _){let G=_[D],J=M[D];if(J.min!=G.min||J.max!=G.max){J.min=G.min,J.max=G.max;let ae=J.distr;J._min=ae==3?Ks(J.min):ae==4?Fm(J.min,J.asinh):ae==100?J.fwd(J.min):J.min,J._max=ae==3?Ks(J.max):ae==4?Fm(J.max,J.asinh):ae==100?J.fwd(J.max):J.max,w[D]=L=!0}}if(L){x.forEach((D,G)=>{s==2?G>0&&w.y&&(D._paths=null):w[D.scale]&&(D._paths=null)});for(let D in w)be=!0,Dn("setScale",D);me&&ue.left>=0&&(te=pe=!0)}for(let D in F)F[D]=null}function ze(_){let w=qm(cn-1,0,sn-1),L=qm(hn+1,0,sn-1);for(;_[w]==null&&w>0;)w--;for(;_[L]==null&&L<sn-1;)L++;return[w,L]}function gt(){if(sn>0){let _=x.some(w=>w._focus)&&Re!=Be.alpha;_&&(u.globalAlpha=Re=Be.alpha),x.forEach((w,L)=>{if(L>0&&w.show&&(Qt(L,!1),Qt(L,!0),w._paths==null)){let D=Re;Re!=w.alpha&&(u.globalAlpha=Re=w.alpha);let G=s==2?[0,e[L][0].length-1]:ze(e[L]);w._paths=w.paths(n,L,G[0],G[1]),Re!=D&&(u.globalAlpha=Re=D)}}),x.forEach((w,L)=>{if(L>0&&w.show){let D=Re;Re!=w.alpha&&(u.globalAlpha=Re=w.alpha),w._paths!=null&&It(L,!1);{let G=w._paths!=null?w._paths.gaps:null,J=w.points.show(n,L,cn,hn,G),ae=w.points.filter(n,L,J,G);(J||ae)&&(w.points._paths=w.points.paths(n,L,cn,hn,ae),It(L,!0))}Re!=D&&(u.globalAlpha=Re=D),Dn("drawSeries",L)}}),_&&(u.globalAlpha=Re=1)}}function Qt(_,w){let L=w?x[_].points:x[_];L._stroke=L.stroke(n,_),L._fill=L.fill(n,_)}function It(_,w){let L=w?x[_].points:x[_],{stroke:D,fill:G,clip:J,flags:ae,_stroke:fe=L._stroke,_fill:we=L._fill,_width:De=L.width}=L._paths;De=Bt(De*At,3);let ke=null,Fe=De%2/2;w&&we==null&&(we=De>0?"#fff":fe);let ot=L.pxAlign==1&&Fe>0;if(ot&&u.translate(Fe,Fe),!w){let Et=P-De/2,Mt=b-De/2,vt=X+De,Je=he+De;ke=new Path2D,ke.rect(Et,Mt,vt,Je)}w?Oe(fe,De,L.dash,L.cap,we,D,G,ae,J):Dt(_,fe,De,L.dash,L.cap,we,D,G,ae,ke,J),ot&&u.translate(-Fe,-Fe)}function Dt(_,w,L,D,G,J,ae,fe,we,De,ke){let Fe=!1;we!=0&&R.forEach((ot,Et)=>{if(ot.series[0]==_){let Mt=x[ot.series[1]],vt=e[ot.series[1]],Je=(Mt._paths||$l).band;Mr(Je)&&(Je=ot.dir==1?Je[0]:Je[1]);let Xe,Wt=null;Mt.show&&Je&&qP(vt,cn,hn)?(Wt=ot.fill(n,Et)||J,Xe=Mt._paths.clip):Je=null,Oe(w,L,D,G,Wt,ae,fe,we,De,ke,Xe,Je),Fe=!0}}),Fe||Oe(w,L,D,G,J,ae,fe,we,De,ke)}let Mn=ga|Km;function Oe(_,w,L,D,G,J,ae,fe,we,De,ke,Fe){Ae(_,w,L,D,G),(we||De||Fe)&&(u.save(),we&&u.clip(we),De&&u.clip(De)),Fe?(fe&Mn)==Mn?(u.clip(Fe),ke&&u.clip(ke),yt(G,ae),pn(_,J,w)):fe&Km?(yt(G,ae),u.clip(Fe),pn(_,J,w)):fe&ga&&(u.save(),u.clip(Fe),ke&&u.clip(ke),yt(G,ae),u.restore(),pn(_,J,w)):(yt(G,ae),pn(_,J,w)),(we||De||Fe)&&u.restore()}function pn(_,w,L){L>0&&(w instanceof Map?w.forEach((D,G)=>{u.strokeStyle=ho=G,u.stroke(D)}):w!=null&&_&&u.stroke(w))}function yt(_,w){w instanceof Map?w.forEach((L,D)=>{u.fillStyle=Qs=D,u.fill(L)}):w!=null&&_&&u.fill(w)}function Rs(_,w,L,D){let G=C[_],J;if(D<=0)J=[0,0];else{let ae=G._space=G.space(n,_,w,L,D),fe=G._incrs=G.incrs(n,_,w,L,D,ae);J=f2(w,L,fe,D,ae)}return G._found=J}function mn(_,w,L,D,G,J,ae,fe,we,De){let ke=ae%2/2;y==1&&u.translate(ke,ke),Ae(fe,ae,we,De,fe),u.beginPath();let Fe,ot,Et,Mt,vt=G+(D==0||D==3?-J:J);L==0?(ot=G,Mt=vt):(Fe=G,Et=vt);for(let Je=0;Je<_.length;Je++)w[Je]!=null&&(L==0?Fe=Et=_[Je]:ot=Mt=_[Je],u.moveTo(Fe,ot),u.lineTo(Et,Mt));u.stroke(),y==1&&u.translate(-ke,-ke)}function fo(_){let w=!0;return C.forEach((L,D)=>{if(!L.show)return;let G=M[L.scale];if(G.min==null){L._show&&(w=!1,L._show=!1,dt(!1));return}else L._show||(w=!1,L._show=!0,dt(!1));let J=L.side,ae=J%2,{min:fe,max:we}=G,[De,ke]=Rs(D,fe,we,ae==0?U:Pe);if(ke==0)return;let Fe=G.distr==2,ot=L._splits=L.splits(n,D,fe,we,De,ke,Fe),Et=G.distr==2?ot.map(Xe=>di[Xe]):ot,Mt=G.distr==2?di[ot[1]]-di[ot[0]]:De,vt=L._values=L.values(n,L.filter(n,Et,D,ke,Mt),D,ke,Mt);L._rotate=J==2?L.rotate(n,vt,D,ke):0;let Je=L._size;L._size=Oi(L.size(n,vt,D,_)),Je!=null&&L._size!=Je&&(w=!1)}),w}function rs(_){let w=!0;return Aa.forEach((L,D)=>{let G=L(n,D,is,_);G!=Ui[D]&&(w=!1),Ui[D]=G}),w}function Ls(){for(let _=0;_<C.length;_++){let w=C[_];if(!w.show||!w._show)continue;let L=w.side,D=L%2,G,J,ae=w.stroke(n,_),fe=L==0||L==3?-1:1,[we,De]=w._found;if(w.label!=null){let Jn=w.labelGap*fe,mi=An((w._lpos+Jn)*At);Le(w.labelFont[0],ae,"center",L==2?"top":Xy),u.save(),D==1?(G=J=0,u.translate(mi,An(b+he/2)),u.rotate((L==3?-Sd:Sd)/2)):(G=An(P+X/2),J=mi);let Pr=Nx(w.label)?w.label(n,_,we,De):w.label;u.fillText(Pr,G,J),u.restore()}if(De==0)continue;let ke=M[w.scale],Fe=D==0?X:he,ot=D==0?P:b,Et=w._splits,Mt=ke.distr==2?Et.map(Jn=>di[Jn]):Et,vt=ke.distr==2?di[Et[1]]-di[Et[0]]:we,Je=w.ticks,Xe=w.border,Wt=Je.show?Je.size:0,on=An(Wt*At),Nn=An((w.alignTo==2?w._size-Wt-w.gap:w.gap)*At),Ot=w._rotate*-Sd/180,an=p(w._pos*At),fi=(on+Nn)*fe,Zn=an+fi;J=D==0?Zn:0,G=D==1?Zn:0;let Mi=w.font[0],Fi=w.align==1?ha:w.align==2?km:Ot>0?ha:Ot<0?km:D==0?"center":L==3?km:ha,ls=Ot||D==1?"middle":L==2?"top":Xy;Le(Mi,ae,Fi,ls);let pi=w.font[1]*w.lineGap,Ti=Et.map(Jn=>p(a(Jn,ke,Fe,ot))),Bi=w._values;for(let Jn=0;Jn<Bi.length;Jn++){let mi=Bi[Jn];if(mi!=null){D==0?G=Ti[Jn]:J=Ti[Jn],mi=""+mi;let Pr=mi.indexOf(`
`)==-1?[mi]:mi.split(/\n/gm);for(let jn=0;jn<Pr.length;jn++){let s0=Pr[jn];Ot?(u.save(),u.translate(G,J+jn*pi),u.rotate(Ot),u.fillText(s0,0,0),u.restore()):u.fillText(s0,G,J+jn*pi)}}}Je.show&&mn(Ti,Je.filter(n,Mt,_,De,vt),D,L,an,on,Bt(Je.width*At,3),Je.stroke(n,_),Je.dash,Je.cap);let cs=w.grid;cs.show&&mn(Ti,cs.filter(n,Mt,_,De,vt),D,D==0?2:1,D==0?b:P,D==0?he:X,Bt(cs.width*At,3),cs.stroke(n,_),cs.dash,cs.cap),Xe.show&&mn([an],[1],D==0?1:0,D==0?1:2,D==1?b:P,D==1?he:X,Bt(Xe.width*At,3),Xe.stroke(n,_),Xe.dash,Xe.cap)}Dn("drawAxes")}function dt(_){x.forEach((w,L)=>{L>0&&(w._paths=null,_&&(s==1?(w.min=null,w.max=null):w.facets.forEach(D=>{D.min=null,D.max=null})))})}let rn=!1,Kn=!1,Nt=[];function gn(){Kn=!1;for(let _=0;_<Nt.length;_++)Dn(...Nt[_]);Nt.length=0}function Wn(){rn||(oR(zg),rn=!0)}function rc(_,w=!1){rn=!0,Kn=w,_(n),zg(),w&&Nt.length>0&&queueMicrotask(gn)}n.batch=rc;function zg(){if(oe&&(mt(),oe=!1),be&&(Te(),be=!1),xe){if($t(f,ha,Ye),$t(f,"top",lt),$t(f,Hl,U),$t(f,Wl,Pe),$t(g,ha,Ye),$t(g,"top",lt),$t(g,Hl,U),$t(g,Wl,Pe),$t(d,Hl,nn),$t(d,Wl,fn),h.width=An(nn*At),h.height=An(fn*At),C.forEach(({_el:_,_show:w,_size:L,_pos:D,side:G})=>{if(_!=null)if(w){let J=G===3||G===0?L:0,ae=G%2==1;$t(_,ae?"left":"top",D-J),$t(_,ae?"width":"height",L),$t(_,ae?"top":"left",ae?lt:Ye),$t(_,ae?"height":"width",ae?Pe:U),Wm(_,eo)}else bi(_,eo)}),ho=Qs=uo=B=j=Y=K=Ee=S=null,Re=1,Ia(!0),Ye!=Me||lt!=Ut||U!=He||Pe!=qe){dt(!1);let _=U/He,w=Pe/qe;if(me&&!te&&ue.left>=0){ue.left*=_,ue.top*=w,po&&ws(po,An(ue.left),0,U,Pe),mo&&ws(mo,0,An(ue.top),U,Pe);for(let L=0;L<ht.length;L++){let D=ht[L];D!=null&&(Vt[L]*=_,Yn[L]*=w,ws(D,Oi(Vt[L]),Oi(Yn[L]),U,Pe))}}if(Ht.show&&!se&&Ht.left>=0&&Ht.width>0){Ht.left*=_,Ht.width*=_,Ht.top*=w,Ht.height*=w;for(let L in bf)$t(vo,L,Ht[L])}Me=Ye,Ut=lt,He=U,qe=Pe}Dn("setSize"),xe=!1}nn>0&&fn>0&&(u.clearRect(0,0,h.width,h.height),Dn("drawClear"),E.forEach(_=>_()),Dn("draw")),Ht.show&&se&&(oc(Ht),se=!1),me&&te&&(Cr(null,!0,!1),te=!1),de.show&&de.live&&pe&&(yf(),pe=!1),l||(l=!0,n.status=1,Dn("ready")),js=!1,rn=!1}n.redraw=(_,w)=>{be=w||!1,_!==!1?tr(T,N.min,N.max):Wn()};function gf(_,w){let L=M[_];if(L.from==null){if(sn==0){let D=L.range(n,w.min,w.max,_);w.min=D[0],w.max=D[1]}if(w.min>w.max){let D=w.min;w.min=w.max,w.max=D}if(sn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;_==T&&L.distr==2&&sn>0&&(w.min=Qi(w.min,e[0]),w.max=Qi(w.max,e[0]),w.min==w.max&&w.max++),F[_]=w,oe=!0,Wn()}}n.setScale=gf;let _f,vf,po,mo,Vg,Gg,go,_o,Hg,Wg,Gt,Kt,er=!1,zn=ue.drag,Ln=zn.x,In=zn.y;me&&(ue.x&&(_f=ki(RP,g)),ue.y&&(vf=ki(LP,g)),N.ori==0?(po=_f,mo=vf):(po=vf,mo=_f),Gt=ue.left,Kt=ue.top);let Ht=n.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),vo=Ht.show?ki(PP,Ht.over?g:f):null;function oc(_,w){if(Ht.show){for(let L in _)Ht[L]=_[L],L in bf&&$t(vo,L,_[L]);w!==!1&&Dn("setSelect")}}n.setSelect=oc;function dw(_){if(x[_].show)ee&&Wm(Ze[_],eo);else if(ee&&bi(Ze[_],eo),me){let L=Ce?ht[0]:ht[_];L!=null&&ws(L,-10,-10,U,Pe)}}function tr(_,w,L){gf(_,{min:w,max:L})}function os(_,w,L,D){w.focus!=null&&_w(_),w.show!=null&&x.forEach((G,J)=>{J>0&&(_==J||_==null)&&(G.show=w.show,dw(J),s==2?(tr(G.facets[0].scale,null,null),tr(G.facets[1].scale,null,null)):tr(G.scale,null,null),Wn())}),L!==!1&&Dn("setSeries",_,w),D&&Da("setSeries",n,_,w)}n.setSeries=os;function fw(_,w){xn(R[_],w)}function pw(_,w){_.fill=bt(_.fill||null),_.dir=Tt(_.dir,-1),w=w??R.length,R.splice(w,0,_)}function mw(_){_==null?R.length=0:R.splice(_,1)}n.addBand=pw,n.setBand=fw,n.delBand=mw;function gw(_,w){x[_].alpha=w,me&&ht[_]!=null&&(ht[_].style.opacity=w),ee&&Ze[_]&&(Ze[_].style.opacity=w)}let Is,nr,Ar,yo={focus:!0};function _w(_){if(_!=Ar){let w=_==null,L=Be.alpha!=1;x.forEach((D,G)=>{if(s==1||G>0){let J=w||G==0||G==_;D._focus=w?null:J,L&&gw(G,J?1:Be.alpha)}}),Ar=_,L&&Wn()}}ee&&Qe&&wt(Ky,ve,_=>{ue._lock||(je(_),Ar!=null&&os(null,yo,!0,_n.setSeries))});function as(_,w,L){let D=M[w];L&&(_=_/At-(D.ori==1?lt:Ye));let G=U;D.ori==1&&(G=Pe,_=G-_),D.dir==-1&&(_=G-_);let J=D._min,ae=D._max,fe=_/G,we=J+(ae-J)*fe,De=D.distr;return De==3?fa(10,we):De==4?YP(we,D.asinh):De==100?D.bwd(we):we}function vw(_,w){let L=as(_,T,w);return Qi(L,e[0],cn,hn)}n.valToIdx=_=>Qi(_,e[0]),n.posToIdx=vw,n.posToVal=as,n.valToPos=(_,w,L)=>M[w].ori==0?r(_,M[w],L?X:U,L?P:0):o(_,M[w],L?he:Pe,L?b:0),n.setCursor=(_,w,L)=>{Gt=_.left,Kt=_.top,Cr(null,w,L)};function Xg(_,w){$t(vo,ha,Ht.left=_),$t(vo,Hl,Ht.width=w)}function qg(_,w){$t(vo,"top",Ht.top=_),$t(vo,Wl,Ht.height=w)}let Ra=N.ori==0?Xg:qg,La=N.ori==1?Xg:qg;function yw(){if(ee&&de.live)for(let _=s==2?1:0;_<x.length;_++){if(_==0&&ct)continue;let w=de.values[_],L=0;for(let D in w)Ue[_][L++].firstChild.nodeValue=w[D]}}function yf(_,w){if(_!=null&&(_.idxs?_.idxs.forEach((L,D)=>{ie[D]=L}):jP(_.idx)||ie.fill(_.idx),de.idx=ie[0]),ee&&de.live){for(let L=0;L<x.length;L++)(L>0||s==1&&!ct)&&xw(L,ie[L]);yw()}pe=!1,w!==!1&&Dn("setLegend")}n.setLegend=yf;function xw(_,w){let L=x[_],D=_==0&&W==2?di:e[_],G;ct?G=L.values(n,_,w)??rt:(G=L.value(n,w==null?null:D[w],_,w),G=G==null?rt:{_:G}),de.values[_]=G}function Cr(_,w,L){Hg=Gt,Wg=Kt,[Gt,Kt]=ue.move(n,Gt,Kt),ue.left=Gt,ue.top=Kt,me&&(po&&ws(po,An(Gt),0,U,Pe),mo&&ws(mo,0,An(Kt),U,Pe));let D,G=cn>hn;Is=Ft,nr=null;let J=N.ori==0?U:Pe,ae=N.ori==1?U:Pe;if(Gt<0||sn==0||G){D=ue.idx=null;for(let fe=0;fe<x.length;fe++){let we=ht[fe];we!=null&&ws(we,-10,-10,U,Pe)}Qe&&os(null,yo,!0,_==null&&_n.setSeries),de.live&&(ie.fill(D),pe=!0)}else{let fe,we,De;s==1&&(fe=N.ori==0?Gt:Kt,we=as(fe,T),D=ue.idx=Qi(we,e[0],cn,hn),De=H(e[0][D],N,J,0));let ke=-10,Fe=-10,ot=0,Et=0,Mt=!0,vt="",Je="";for(let Xe=s==2?1:0;Xe<x.length;Xe++){let Wt=x[Xe],on=ie[Xe],Nn=on==null?null:s==1?e[Xe][on]:e[Xe][1][on],Ot=ue.dataIdx(n,Xe,D,we),an=Ot==null?null:s==1?e[Xe][Ot]:e[Xe][1][Ot];if(pe=pe||an!=Nn||Ot!=on,ie[Xe]=Ot,Xe>0&&Wt.show){let fi=Ot==null?-10:Ot==D?De:H(s==1?e[0][Ot]:e[Xe][0][Ot],N,J,0),Zn=an==null?-10:I(an,s==1?M[Wt.scale]:M[Wt.facets[1].scale],ae,0);if(Qe&&an!=null){let Mi=N.ori==1?Gt:Kt,Fi=Cn(Be.dist(n,Xe,Ot,Zn,Mi));if(Fi<Is){let ls=Be.bias;if(ls!=0){let pi=as(Mi,Wt.scale),Ti=an>=0?1:-1,Bi=pi>=0?1:-1;Bi==Ti&&(Bi==1?ls==1?an>=pi:an<=pi:ls==1?an<=pi:an>=pi)&&(Is=Fi,nr=Xe)}else Is=Fi,nr=Xe}}if(pe||Ce){let Mi,Fi;N.ori==0?(Mi=fi,Fi=Zn):(Mi=Zn,Fi=fi);let ls,pi,Ti,Bi,cs,Jn,mi=!0,Pr=ce.bbox;if(Pr!=null){mi=!1;let jn=Pr(n,Xe);Ti=jn.left,Bi=jn.top,ls=jn.width,pi=jn.height}else Ti=Mi,Bi=Fi,ls=pi=ce.size(n,Xe);if(Jn=ce.fill(n,Xe),cs=ce.stroke(n,Xe),Ce)Xe==nr&&Is<=Be.prox&&(ke=Ti,Fe=Bi,ot=ls,Et=pi,Mt=mi,vt=Jn,Je=cs);else{let jn=ht[Xe];jn!=null&&(Vt[Xe]=Ti,Yn[Xe]=Bi,nx(jn,ls,pi,mi),ex(jn,Jn,cs),ws(jn,Oi(Ti),Oi(Bi),U,Pe))}}}}if(Ce){let Xe=Be.prox,Wt=Ar==null?Is<=Xe:Is>Xe||nr!=Ar;if(pe||Wt){let on=ht[0];on!=null&&(Vt[0]=ke,Yn[0]=Fe,nx(on,ot,Et,Mt),ex(on,vt,Je),ws(on,Oi(ke),Oi(Fe),U,Pe))}}}if(Ht.show&&er)if(_!=null){let[fe,we]=_n.scales,[De,ke]=_n.match,[Fe,ot]=_.cursor.sync.scales,Et=_.cursor.drag;if(Ln=Et._x,In=Et._y,Ln||In){let{left:Mt,top:vt,width:Je,height:Xe}=_.select,Wt=_.scales[Fe].ori,on=_.posToVal,Nn,Ot,an,fi,Zn,Mi=fe!=null&&De(fe,Fe),Fi=we!=null&&ke(we,ot);Mi&&Ln?(Wt==0?(Nn=Mt,Ot=Je):(Nn=vt,Ot=Xe),an=M[fe],fi=H(on(Nn,Fe),an,J,0),Zn=H(on(Nn+Ot,Fe),an,J,0),Ra(es(fi,Zn),Cn(Zn-fi))):Ra(0,J),Fi&&In?(Wt==1?(Nn=Mt,Ot=Je):(Nn=vt,Ot=Xe),an=M[we],fi=I(on(Nn,ot),an,ae,0),Zn=I(on(Nn+Ot,ot),an,ae,0),La(es(fi,Zn),Cn(Zn-fi))):La(0,ae)}else wf()}else{let fe=Cn(Hg-Vg),we=Cn(Wg-Gg);if(N.ori==1){let ot=fe;fe=we,we=ot}Ln=zn.x&&fe>=zn.dist,In=zn.y&&we>=zn.dist;let De=zn.uni;De!=null?Ln&&In&&(Ln=fe>=De,In=we>=De,!Ln&&!In&&(we>fe?In=!0:Ln=!0)):zn.x&&zn.y&&(Ln||In)&&(Ln=In=!0);let ke,Fe;Ln&&(N.ori==0?(ke=go,Fe=Gt):(ke=_o,Fe=Kt),Ra(es(ke,Fe),Cn(Fe-ke)),In||La(0,ae)),In&&(N.ori==1?(ke=go,Fe=Gt):(ke=_o,Fe=Kt),La(es(ke,Fe),Cn(Fe-ke)),Ln||Ra(0,J)),!Ln&&!In&&(Ra(0,0),La(0,0))}if(zn._x=Ln,zn._y=In,_==null){if(L){if(i0!=null){let[fe,we]=_n.scales;_n.values[0]=fe!=null?as(N.ori==0?Gt:Kt,fe):null,_n.values[1]=we!=null?as(N.ori==1?Gt:Kt,we):null}Da(Om,n,Gt,Kt,U,Pe,D)}if(Qe){let fe=L&&_n.setSeries,we=Be.prox;Ar==null?Is<=we&&os(nr,yo,!0,fe):Is>we?os(null,yo,!0,fe):nr!=Ar&&os(nr,yo,!0,fe)}}pe&&(de.idx=D,yf()),w!==!1&&Dn("setCursor")}let ir=null;Object.defineProperty(n,"rect",{get(){return ir==null&&Ia(!1),ir}});function Ia(_=!1){_?ir=null:(ir=g.getBoundingClientRect(),Dn("syncRect",ir))}function $g(_,w,L,D,G,J,ae){ue._lock||er&&_!=null&&_.movementX==0&&_.movementY==0||(xf(_,w,L,D,G,J,ae,!1,_!=null),_!=null?Cr(null,!0,!0):Cr(w,!0,!1))}function xf(_,w,L,D,G,J,ae,fe,we){if(ir==null&&Ia(!1),je(_),_!=null)L=_.clientX-ir.left,D=_.clientY-ir.top;else{if(L<0||D<0){Gt=-10,Kt=-10;return}let[De,ke]=_n.scales,Fe=w.cursor.sync,[ot,Et]=Fe.values,[Mt,vt]=Fe.scales,[Je,Xe]=_n.match,Wt=w.axes[0].side%2==1,on=N.ori==0?U:Pe,Nn=N.ori==1?U:Pe,Ot=Wt?J:G,an=Wt?G:J,fi=Wt?D:L,Zn=Wt?L:D;if(Mt!=null?L=Je(De,Mt)?a(ot,M[De],on,0):-10:L=on*(fi/Ot),vt!=null?D=Xe(ke,vt)?a(Et,M[ke],Nn,0):-10:D=Nn*(Zn/an),N.ori==1){let Mi=L;L=D,D=Mi}}we&&(w==null||w.cursor.event.type==Om)&&((L<=1||L>=U-1)&&(L=jr(L,U)),(D<=1||D>=Pe-1)&&(D=jr(D,Pe))),fe?(Vg=L,Gg=D,[go,_o]=ue.move(n,L,D)):(Gt=L,Kt=D)}let bf={width:0,height:0,left:0,top:0};function wf(){oc(bf,!1)}let Yg,Kg,Zg,Jg;function jg(_,w,L,D,G,J,ae){er=!0,Ln=In=zn._x=zn._y=!1,xf(_,w,L,D,G,J,ae,!0,!1),_!=null&&(wt(Um,Gm,Qg,!1),Da($y,n,go,_o,U,Pe,null));let{left:fe,top:we,width:De,height:ke}=Ht;Yg=fe,Kg=we,Zg=De,Jg=ke}function Qg(_,w,L,D,G,J,ae){er=zn._x=zn._y=!1,xf(_,w,L,D,G,J,ae,!1,!0);let{left:fe,top:we,width:De,height:ke}=Ht,Fe=De>0||ke>0,ot=Yg!=fe||Kg!=we||Zg!=De||Jg!=ke;if(Fe&&ot&&oc(Ht),zn.setScale&&Fe&&ot){let Et=fe,Mt=De,vt=we,Je=ke;if(N.ori==1&&(Et=we,Mt=ke,vt=fe,Je=De),Ln&&tr(T,as(Et,T),as(Et+Mt,T)),In)for(let Xe in M){let Wt=M[Xe];Xe!=T&&Wt.from==null&&Wt.min!=Ft&&tr(Xe,as(vt+Je,Xe),as(vt,Xe))}wf()}else ue.lock&&(ue._lock=!ue._lock,Cr(w,!0,_!=null));_!=null&&(Sn(Um,Gm),Da(Um,n,Gt,Kt,U,Pe,null))}function bw(_,w,L,D,G,J,ae){if(ue._lock)return;je(_);let fe=er;if(er){let we=!0,De=!0,ke=10,Fe,ot;N.ori==0?(Fe=Ln,ot=In):(Fe=In,ot=Ln),Fe&&ot&&(we=Gt<=ke||Gt>=U-ke,De=Kt<=ke||Kt>=Pe-ke),Fe&&we&&(Gt=Gt<go?0:U),ot&&De&&(Kt=Kt<_o?0:Pe),Cr(null,!0,!0),er=!1}Gt=-10,Kt=-10,ie.fill(null),Cr(null,!0,!0),fe&&(er=fe)}function e0(_,w,L,D,G,J,ae){ue._lock||(je(_),Pa(),wf(),_!=null&&Da(Zy,n,Gt,Kt,U,Pe,null))}function t0(){C.forEach(p2),O(n.width,n.height,!0)}to(Md,da,t0);let xo={};xo.mousedown=jg,xo.mousemove=$g,xo.mouseup=Qg,xo.dblclick=e0,xo.setSeries=(_,w,L,D)=>{let G=_n.match[2];L=G(n,w,L),L!=-1&&os(L,D,!0,!1)},me&&(wt($y,g,jg),wt(Om,g,$g),wt(Yy,g,_=>{je(_),Ia(!1)}),wt(Ky,g,bw),wt(Zy,g,e0),Zm.add(n),n.syncRect=Ia);let ac=n.hooks=i.hooks||{};function Dn(_,w,L){Kn?Nt.push([_,w,L]):_ in ac&&ac[_].forEach(D=>{D.call(null,n,w,L)})}(i.plugins||[]).forEach(_=>{for(let w in _.hooks)ac[w]=(ac[w]||[]).concat(_.hooks[w])});let n0=(_,w,L)=>L,_n=xn({key:null,setSeries:!1,filters:{pub:ax,sub:ax},scales:[T,x[1]?x[1].scale:null],match:[lx,lx,n0],values:[null,null]},ue.sync);_n.match.length==2&&_n.match.push(n0),ue.sync=_n;let i0=_n.key,Sf=sb(i0);function Da(_,w,L,D,G,J,ae){_n.filters.pub(_,w,L,D,G,J,ae)&&Sf.pub(_,w,L,D,G,J,ae)}Sf.sub(n);function ww(_,w,L,D,G,J,ae){_n.filters.sub(_,w,L,D,G,J,ae)&&xo[_](null,w,L,D,G,J,ae)}n.pub=ww;function Sw(){Sf.unsub(n),Zm.delete(n),Rn.clear(),Xm(Md,da,t0),c.remove(),ve?.remove(),Dn("destroy")}n.destroy=Sw;function Mf(){Dn("init",i,e),Ca(e||i.data,!1),F[T]?gf(T,F[T]):Pa(),se=Ht.show&&(Ht.width>0||Ht.height>0),te=pe=!0,O(i.width,i.height)}return x.forEach(co),C.forEach(Cs),t?t instanceof HTMLElement?(t.appendChild(c),Mf()):t(n,Mf):Mf(),n}bn.assign=xn;bn.fmtNum=ig;bn.rangeNum=Td;bn.rangeLog=Cd;bn.rangeAsinh=tg;bn.orient=io;bn.pxRatio=At;bn.join=rR;bn.fmtDate=rg,bn.tzDate=gR;bn.sync=sb;{bn.addGap=jR,bn.clipGaps=Ld;let i=bn.paths={points:hb};i.linear=db,i.stepped=t2,i.bars=n2,i.spline=s2}function m2(i){if(!(i>0))return 1;let e=10**Math.floor(Math.log10(i));for(let t of[1,2,2.5,5])if(t*e>=i*(1-1e-9))return t*e;return 10*e}function Kl(i,e,t){let n=Math.min(Number.isFinite(i)?i:t[0],t[0]),s=Math.max(Number.isFinite(e)?e:t[1],t[1]),r=m2((s-n)/4),o=r*1e-6;return[Math.floor((n+o)/r)*r,Math.ceil((s-o)/r)*r]}function kd(i){let e=1/0,t=-1/0;for(let n of i)for(let s of n)s<e&&(e=s),s>t&&(t=s);return[e,t]}var g2=44,_2=20,gb="11px B612, sans-serif",Er=class{constructor(e){this.options=e;this.range=Kl(NaN,NaN,e.soft);let t=A("div",{class:"plot-key"});for(let n of e.curves){let s=A("span",{class:"plot-value"});if(this.values.push(s),n.quiet===!0)continue;let r=A("i",{class:n.dash?"swatch dashed":"swatch"});r.style.color=n.colour,t.append(A("span",{class:"plot-curve"},r,n.label,...n.nameOnly===!0?[]:[s]))}this.element=A("section",{class:"plot",id:`plot-${e.id}`,"aria-label":`${e.title}, ${e.unit}`},A("header",{},A("h2",{},e.title,A("span",{class:"plot-unit"},e.unit)),t),this.canvas),this.plot=new bn(this.uplotOptions(),e.curves.reduce(n=>[...n,[]],[[]]),this.canvas)}options;element;canvas=A("div",{class:"plot-canvas"});values=[];plot;end_s=1;from_s=0;range;resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e>0&&t>0&&(e!==this.plot.width||t!==this.plot.height)&&this.plot.setSize({width:e,height:t})}show(e,t){if(St(this.element,"stale",e.stale("/estimate")),e.series.length===0)return;this.end_s=e.series.last_s,this.from_s=Math.max(this.end_s-t,0),this.end_s=Math.max(this.end_s,this.from_s+t);let n=e.series.since(this.from_s),s=o=>n[Lm[o]]??new Float64Array,r=this.options.curves.map(o=>s(o.column));this.range=Kl(...kd(r),this.options.soft),this.plot.setData([s("t_s"),...r]),this.figures()}figures(){let e=this.plot.data,t=this.plot.cursor.idx??(e[0]?.length??0)-1;this.values.forEach((n,s)=>{Ne(n,at(e[s+1]?.[t],this.options.decimals))})}uplotOptions(){let e={stroke:"#1b242e",width:1},t=this.options.times===!0;return{width:300,height:100,legend:{show:!1},padding:[6,10,t?0:4,0],cursor:{y:!1,points:{size:5},drag:{x:!1,y:!1},sync:{key:"time",setSeries:!1}},scales:{x:{time:!1,range:()=>[this.from_s,this.end_s]},y:{range:()=>this.range}},axes:[{show:!0,size:t?_2:0,stroke:aa,font:gb,grid:e,ticks:{show:!1},gap:4,space:48,values:(n,s)=>t?s.map(r=>at(r,0)):s.map(()=>"")},{size:g2,stroke:aa,font:gb,grid:e,ticks:{show:!1},gap:6,space:22,values:(n,s)=>s.map(r=>at(r,v2(s)))}],series:[{},...this.options.curves.map(n=>({stroke:n.colour,width:n.width??1.5,...n.dash?{dash:n.dash}:{},points:{show:!1}}))],hooks:{setCursor:[()=>{this.figures()}]}}}};function v2(i){let e=Math.abs((i[1]??1)-(i[0]??0));return Math.max(0,Math.min(3,Math.ceil(-Math.log10(e)-1e-9)+(/[^0]5/.test(e.toPrecision(2))?1:0)))}var{model:_b,odometry:vb,fused:yb,truth:y2}=Ni,x2={colour:Ji,dash:[5,4],width:1.2},Od=class{element=A("div",{class:"plots"});window_s=60;plots;truth;truthKnown=!1;constructor(){this.truth=new Er({id:"truth",title:"Error to truth",unit:"mm",decimals:1,soft:[0,10],curves:[{label:"model",column:"model_error_mm",colour:_b},{label:"odom",column:"odometry_error_mm",colour:vb},{label:"fused",column:"fused_error_mm",colour:yb}]}),this.truth.element.hidden=!0,this.plots=[new Er({id:"yaw",title:"Yaw",unit:"°",decimals:1,soft:[-10,10],curves:[{label:"truth",column:"truth_yaw_deg",colour:y2,quiet:!0},{label:"model",column:"model_yaw_deg",colour:_b},{label:"odom",column:"odometry_yaw_deg",colour:vb},{label:"fused",column:"fused_yaw_deg",colour:yb},{label:"plan",column:"desired_yaw_deg",...x2,nameOnly:!0}]}),new Er({id:"error",title:"Tracking error",unit:"mm, °",decimals:1,soft:[-4,4],curves:[{label:"cross-track",column:"cross_track_mm",colour:"#d7dee7"},{label:"heading °",column:"heading_error_deg",colour:"#b79cf0"}]}),this.truth,new Er({id:"speed",title:"Track speed",unit:"m/s",decimals:3,soft:[-.05,.15],curves:[{label:"wanted left",column:"left_commanded_mps",colour:Ul,dash:[3,3],width:1,quiet:!0},{label:"wanted right",column:"right_commanded_mps",colour:Fl,dash:[3,3],width:1,quiet:!0},{label:"left",column:"left_mps",colour:Ul},{label:"right",column:"right_mps",colour:Fl}]}),new Er({id:"slip",title:"Slip",unit:"%",decimals:1,soft:[0,20],times:!0,curves:[{label:"fused left",column:"fused_slip_left_percent",colour:Ul,dash:[3,3],width:1,quiet:!0},{label:"fused right",column:"fused_slip_right_percent",colour:Fl,dash:[3,3],width:1,quiet:!0},{label:"left",column:"slip_left_percent",colour:Ul},{label:"right",column:"slip_right_percent",colour:Fl}]})],this.element.append(...this.plots.map(t=>t.element)),new ResizeObserver(()=>{for(let t of this.plots)t.resize()}).observe(this.element)}show(e){!this.truthKnown&&e.get("/estimate")?.truth&&(this.truthKnown=!0,this.truth.element.hidden=!1),St(this.element,"with-truth",this.truthKnown);for(let t of this.plots)t.element.hidden||(t.resize(),t.show(e,this.window_s))}};var Js=({name:i,run:e})=>i===""?e:i,xb=i=>i.files.find(({name:e})=>e==="report.html");var b2=/^compare-(.+)\.html$/;function wb(i,e,t){let n=A("input",{type:"checkbox","aria-label":`Compare ${Js(i)}`});n.checked=e,n.disabled=i.active,n.addEventListener("change",()=>{t.choose(i,n.checked)});let s=A("tr",{"data-run":i.run},A("td",{class:"run-box"},n),A("td",{class:"run-what"},...w2(i)),A("td",{class:"run-when"},i.active?"recording":new Date(1e3*i.modified_unix_s).toLocaleString()),A("td",{class:"figure run-size"},Di(i.bytes)),A("td",{},A("div",{class:"run-files"},...S2(i,t),...M2(i))));return i.active&&s.classList.add("active"),s}function w2(i){let e=[A("span",{class:"run-title"},Js(i))],t=(n,s)=>{s!==""&&e.push(A("span",{class:n},s))};for(let n of i.tags.split(" "))t("run-tag",n);return i.keep&&t("run-tag","kept"),i.name!==""&&t("run-id",i.run),t("run-note",i.note),t("run-bad",i.note_error),e}function bb(i,e,t,n){let s=A("button",{type:"button",class:"link run-deed","aria-label":e},i);return s.dataset.fixed=String(t),s.addEventListener("click",n),s}function S2(i,e){let t=Js(i),n=i.files.find(({name:a})=>a==="run.mcap"),s=xb(i),r=[];if(s!==void 0)r.push(A("a",{class:"run-report",href:s.url,target:"_blank",rel:"noopener","aria-label":`Report of ${t}`},"report"));else if(n!==void 0){let a=bb("make report",`Make the report of ${t}`,i.active,()=>{e.report(i)});a.classList.add("run-make"),r.push(a)}if(n!==void 0){let a=A("button",{type:"button",class:"link","aria-label":`Replay ${t}`},"replay");a.addEventListener("click",()=>{e.replay(n,i)}),r.push(a)}for(let{name:a,url:l}of i.files){let c=b2.exec(a)?.[1];c!==void 0&&r.push(A("a",{href:l,target:"_blank",rel:"noopener",title:`with ${c}`},"comparison"))}r.push(bb("edit",`Name and note of ${t}`,!1,()=>{e.edit(i)}));let o=A("button",{type:"button",class:"link run-deed run-delete","aria-label":`Delete ${t}`},"delete");return o.dataset.fixed=String(i.active||n===void 0),lc(o,"really delete",()=>{e.remove(i)}),[...r,o]}function M2(i){let e=i.files.filter(({kind:t})=>t!=="note").map(({name:t,url:n,bytes:s})=>A("a",{href:n,download:"",title:Di(s)},t));return e.length===0?[]:[A("details",{class:"run-more"},A("summary",{},e.length===1?"1 file":`${e.length} files`),...e)]}function Sb(i,e,t){let n=A("input",{type:"text",name:"run-name",maxlength:"80",value:i.name}),s=A("input",{type:"text",name:"run-tags",maxlength:"200",value:i.tags,placeholder:"words"}),r=A("textarea",{name:"run-note",rows:"2",maxlength:"2000","aria-label":"Note"},i.note),o=A("input",{type:"checkbox",name:"run-keep"});o.checked=i.keep;let a=A("button",{type:"button",class:"control"},"Cancel");a.addEventListener("click",t);let l=A("form",{class:"run-form","aria-label":`Name and note of ${Js(i)}`},A("label",{},"name ",n),A("label",{},"tags ",s),A("label",{},o," keep"),r,A("button",{type:"submit",class:"control run-save"},"Save"),a);return l.addEventListener("submit",c=>{c.preventDefault(),e({run:i.run,name:n.value.trim(),tags:s.value.trim().replace(/\s+/g," "),note:r.value.trim(),keep:o.checked})}),A("tr",{class:"run-edited"},A("td",{colspan:"5"},l))}var T2=5e3,dg=2,Ud=class{constructor(e,t,n=()=>performance.now()){this.ask=t;this.now=n;let s=["","run","recorded","size",""].map(r=>A("th",{scope:"col"},r));this.table=A("table",{},A("thead",{},A("tr",{},...s)),this.body),this.element.append(A("div",{class:"runs-bar"},this.room,this.compareButton,this.busy,this.said),this.table,this.empty),this.table.hidden=!0,this.compareButton.addEventListener("click",()=>{let[r,o]=(this.list?.runs??[]).filter(({run:a})=>this.chosen.has(a));r!==void 0&&o!==void 0&&this.make(`the comparison of ${Js(r)} with ${Js(o)}`,{name:"run_compare",request:{run:r.run,with:o.run}})}),this.actions={replay:e,report:r=>{this.make(`the report of ${Js(r)}`,{name:"run_report",request:{run:r.run}})},edit:({run:r})=>{this.edit(r)},remove:({run:r})=>{this.change({name:"run_delete",request:{run:r}})},choose:({run:r},o)=>{o?this.chosen.add(r):this.chosen.delete(r),this.enable()}}}ask;now;element=A("div",{class:"runs",tabindex:"0"});body=A("tbody");empty=A("p",{class:"empty"});table;room=A("span",{class:"runs-room"});compareButton=A("button",{type:"button",class:"control",id:"compare"},"Compare");busy=A("span",{class:"runs-room"});said=A("p",{class:"runs-said",role:"status"});rows=new Map;chosen=new Set;actions;list;shown="";next_ms=0;mayCommand=!1;replayed="";editing;making;show(e,t){this.mayCommand=e,this.replayed=t,this.enable(),this.making!==void 0&&Ne(this.said,`Making ${this.making.what} … ${((this.now()-this.making.since_ms)/1e3).toFixed(0)} s`),!(this.now()<this.next_ms)&&(this.next_ms=this.now()+T2,this.load())}changed(){this.next_ms=0}enable(){let e=this.making!==void 0||(this.list?.making??"")!=="";this.compareButton.disabled=!this.mayCommand||e||this.chosen.size!==dg,this.compareButton.title=this.chosen.size===dg?"":"Choose two runs";for(let t of this.body.querySelectorAll(".run-deed")){let n=t.closest("tr")?.dataset.run,s=t.classList.contains("run-delete")&&n===this.replayed;t.disabled=!this.mayCommand||t.dataset.fixed==="true"||s||e&&t.classList.contains("run-make")}}async load(){try{let e=await fetch("/api/runs",{cache:"no-store"});if(!e.ok)throw new Error(e.statusText);let t=await e.text();if(t===this.shown)return;this.shown=t,this.build(this.list=JSON.parse(t))}catch{this.shown="",this.empty.hidden=!this.table.hidden,this.empty.textContent="The list of runs is not available now."}}build(e){let{runs:t,directory:n}=e,s=new Set(t.map(({run:a})=>a));for(let a of[...this.rows.keys()])s.has(a)||this.rows.delete(a);for(let a of[...this.chosen])s.has(a)||this.chosen.delete(a);let r=t.map(a=>this.row(a)),o=r.length===this.body.children.length;(!o||r.some((a,l)=>this.body.children[l]!==a))&&(o?r.forEach((a,l)=>{this.body.children[l]!==a&&this.body.children[l]?.replaceWith(a)}):this.body.replaceChildren(...r)),this.table.hidden=t.length===0,this.empty.hidden=t.length>0,this.empty.textContent=n?`No runs in ${n} yet. Press Record, or start tp100d with --record.`:"Nothing is recorded: start tp100d with --record DIR.",Ne(this.room,n===""?"":E2(e)),this.compareButton.hidden=t.length<dg,Ne(this.busy,e.making===""||this.making!==void 0?"":`A report of ${e.making} is being made.`),this.enable()}row(e){let t=JSON.stringify(e),n=this.rows.get(e.run);if(n!==void 0&&(n.text===t||this.editing===e.run))return n.element;let s=wb(e,this.chosen.has(e.run),this.actions);return this.rows.set(e.run,{text:t,element:s}),s}edit(e){this.editing!==void 0&&this.endEdit();let t=this.list?.runs.find(o=>o.run===e),n=this.rows.get(e)?.element;if(t===void 0||n===void 0)return;let r=Sb(t,o=>{this.change({name:"run_note",request:o}).then(a=>{a&&this.endEdit()})},()=>{this.endEdit()});n.replaceWith(r),this.editing=e,this.rows.set(e,{text:"",element:r}),r.querySelector("input")?.focus()}endEdit(){let e=this.editing;this.editing=void 0;let t=this.list?.runs.find(s=>s.run===e),n=e===void 0?void 0:this.rows.get(e);t===void 0||n===void 0||(this.rows.delete(t.run),n.element.replaceWith(this.row(t)),this.reload())}reload(){this.shown="",this.next_ms=0}async change(e){this.say("");try{return await this.ask(e),!0}catch(t){return this.fail(t),!1}finally{this.reload()}}async make(e,t){this.making={what:e,since_ms:this.now()},this.say(""),this.enable();try{let{url:n}=await this.ask(t),s=A("a",{href:n,target:"_blank",rel:"noopener",id:"made"},`Open ${e}`);this.making=void 0,this.said.replaceChildren(s),window.open(n,"_blank","noopener")}catch(n){this.making=void 0,this.fail(n,`${e} is not made: `)}finally{this.reload()}}fail(e,t=""){this.say(t+(e instanceof Error?e.message:String(e)),!0)}say(e,t=!1){Ne(this.said,e),St(this.said,"bad",t)}};function E2({runs:i,bytes:e,quota_bytes:t,free_bytes:n}){let s=i.length===1?"1 run":`${i.length} runs`,r=t>0?` of at most ${Di(t)}`:"";return`${s}, ${Di(e)}${r} · ${Di(n)} free`}var A2=["/estimate","/sample","/command","/slip","/link","/loop","/state"],Jl=300,Mb=.0399,C2=4,P2=4;function pg(i){return A2.includes(i)}function xa(i){return i.slice(0,Math.max(i.indexOf("."),0))}function R2(i,e){let t=[],n=(s,r,o)=>{if(typeof r=="number"||typeof r=="boolean")t.push(s);else{if(typeof r!="object"||r===null||o===P2)return;if(Array.isArray(r)&&r.length>C2)return;for(let[a,l]of Object.entries(r))(o>0||a!=="t_s")&&n(`${s}.${a}`,l,o+1)}};return n(i,e,0),t}function fg(i,e){let t=e;for(let n of i.split(".").slice(1)){if(typeof t!="object"||t===null||!Object.hasOwn(t,n))return NaN;t=t[n]}return typeof t=="boolean"?Number(t):typeof t=="number"&&Number.isFinite(t)?t:NaN}function Tb(i){return fg(".t_s",i)}function mg(i){let e=i.split(".").filter(r=>!/^\d+$/.test(r)).at(-1)??"",n=[[/_radps$/,"rad/s"],[/_mps2$/,"m/s²"],[/_mps$/,"m/s"],[/_degc$/,"°C"],[/_rad$/,"rad"],[/_hz$/,"Hz"],[/_ppm$/,"ppm"],[/_bytes_ps$/,"B/s"],[/_ms$/,"ms"],[/_us$/,"µs"],[/_m$/,"m"],[/_s$/,"s"],[/_v$/,"V"]].find(([r])=>r.test(e));return n!==void 0?n[1]:/_us\.(mean|p50|p99|p999|max)$/.test(i)?"µs":""}function Eb(i,e){let t=e.toLowerCase().split(/\s+/);return i.filter(n=>t.every(s=>n.toLowerCase().includes(s)))}var Zl=class{constructor(e=Math.ceil(Jl/Mb),t=Mb){this.capacity=e;this.interval_s=t}capacity;interval_s;series=new Map;known=new Set;seen={};get names(){return[...this.series.keys()]}get fields(){return[...this.known].sort()}of(e){return this.series.get(e)}choose(e){this.series.has(e)||this.series.set(e,new la(2,this.capacity,this.interval_s))}drop(e){this.series.delete(e)}receive(e,t){if(!pg(e))return;let n=Tb(t);if(Number.isFinite(n)){if(!(Math.abs(n-(this.seen[e]??-1/0))<1)){this.seen[e]=n;for(let s of R2(e,t))this.known.add(s)}for(let[s,r]of this.series)xa(s)===e&&r.push([n,fg(s,t)])}}before(e,t){this.series.get(e)?.before(t.map(n=>[Tb(n),fg(e,n)]))}};function Ab(i){let e=new Map;i.forEach(({times:n,values:s},r)=>{n.forEach((o,a)=>{let l=o.toFixed(6),c=e.get(l)??i.map(()=>""),h=s[a]??NaN;Number.isFinite(h)&&(c[r]=String(h)),e.set(l,c)})});let t=[...e].sort(([n],[s])=>Number(n)-Number(s));return[["t_s",...i.map(({name:n})=>n)],...t.map(([n,s])=>[n,...s])].map(n=>n.join(",")).join(`
`)+`
`}var Fd=["#4d9fff","#ffb020","#3ad07c","#ff6f4d","#b79cf0","#e8e36a","#5fd7d7","#e58cc4"],L2="11px B612, sans-serif",Cb=170,Bd=class{constructor(e,t,n){this.names=e;this.unit=t;this.zoom=n;let s=A("div",{class:"plot-key"});e.forEach((r,o)=>{let a=A("i",{class:"swatch"});a.style.color=Fd[o%Fd.length]??"";let l=A("span",{class:"plot-value"});this.values.push(l),s.append(A("span",{class:"plot-curve"},a,r,l))}),this.element=A("section",{class:"plot signal-chart","aria-label":`${e.join(", ")} ${t}`},A("header",{},s,A("span",{class:"plot-unit"},t)),this.canvas),this.plot=new bn(this.options(),[[],...e.map(()=>[])],this.canvas)}names;unit;zoom;element;canvas=A("div",{class:"plot-canvas"});values=[];plot;range={from_s:0,to_s:1};now_s=NaN;y=[0,1];show(e,t,n){this.range=t,this.now_s=n;let s=[],r=[];for(let u of this.names){let[d=new Float64Array,f=new Float64Array]=e.of(u)?.since(t.from_s)??[],g=d.length;for(;g>1&&(d[g-2]??0)>t.to_s;)g--;s.push([d.subarray(0,g),f.subarray(0,g)]),r.push(f.subarray(0,g))}let[o,a]=kd(r),c=a-o>0?0:Math.max(Math.abs(o)*.01,1e-6);this.y=Kl(o-c,a+c,[o-c,a+c]);let{clientWidth:h}=this.canvas;h>0&&h!==this.plot.width&&this.plot.setSize({width:h,height:Cb}),this.plot.setData(bn.join(s)),this.figures()}destroy(){this.plot.destroy(),this.element.remove()}get image(){return this.plot.ctx.canvas}colour(e){return Fd[e%Fd.length]??""}figures(){let e=this.plot.cursor.idx;this.names.forEach((t,n)=>{let s=this.plot.data[n+1]??[],r=e??s.length-1;for(;r>0&&(s[r]===void 0||s[r]===null);)r--;let o=s[r]??NaN,a=this.values[n];a!==void 0&&Ne(a,Number.isFinite(o)?at(o,I2(this.y)):at(null,0))})}options(){let e={stroke:aa,font:L2,grid:{stroke:"#1b242e",width:1},ticks:{show:!1}};return{width:300,height:Cb,legend:{show:!1},padding:[6,10,0,0],cursor:{y:!1,points:{size:5},drag:{x:!0,y:!1,setScale:!1},sync:{key:"signals",setSeries:!1}},scales:{x:{time:!1,range:()=>[this.range.from_s,this.range.to_s]},y:{range:()=>this.y}},axes:[{...e,size:20,gap:4,space:60,values:(t,n)=>n.map(s=>`${at(s,n.length>1&&(n[1]??0)-(n[0]??0)<1?2:0)} s`)},{...e,size:58,gap:6,space:24}],series:[{},...this.names.map((t,n)=>({stroke:this.colour(n),width:1.5,points:{show:!1},spanGaps:!0}))],hooks:{setCursor:[()=>{this.figures()}],setSelect:[t=>{if(t.select.width<4)return;let n=t.posToVal(t.select.left,"x"),s=t.posToVal(t.select.left+t.select.width,"x");t.setSelect({left:0,top:0,width:0,height:0},!1),this.zoom({from_s:n,to_s:s})}],draw:[t=>{this.drawNow(t)}]}}}drawNow(e){if(!(this.now_s>this.range.from_s&&this.now_s<this.range.to_s))return;let t=e.valToPos(this.now_s,"x",!0);e.ctx.fillStyle=aa,e.ctx.fillRect(Math.round(t),e.bbox.top,1,e.bbox.height)}};function I2([i,e]){return Math.max(0,Math.min(6,3-Math.ceil(Math.log10(e-i||1))))}var Lb="tp100.signals",zd=8,D2=80,gg=1,Pb=60,N2=2e4,Vd=class{constructor(e){this.past=e;let t=jl("signals-in","+","Shorter time"),n=jl("signals-out","−","Longer time"),s=jl("signals-csv","CSV","Save the shown values as a table"),r=jl("signals-png","PNG","Save the diagrams as a picture");this.element.append(this.chooser,A("div",{class:"signal-view"},A("div",{class:"signal-tools"},n,t,this.pauseButton,s,r),this.charts_)),this.search.addEventListener("input",()=>{this.showList()}),t.addEventListener("click",()=>{this.scale(.5)}),n.addEventListener("click",()=>{this.scale(2)}),this.pauseButton.addEventListener("click",()=>{let{from_s:o,to_s:a}=this.range,l=this.now_s>o?Math.min(a,this.now_s):a;this.fixed=this.fixed===void 0?{from_s:o,to_s:l}:void 0,this.draw()}),s.addEventListener("click",()=>{this.saveTable()}),r.addEventListener("click",()=>{this.saveImage()});for(let o of k2())this.choose(o);this.live.names.length>0&&innerWidth<700&&this.chooser.removeAttribute("open")}past;element=A("div",{class:"signals",tabindex:"0"});search=A("input",{type:"search",placeholder:"search fields","aria-label":"Search signals"});list=A("ul",{class:"signal-list"});chosen=A("summary",{});chooser=A("details",{class:"signal-chooser",open:""},this.chosen,this.search,this.list);pauseButton=jl("signals-pause","Pause","Stop and go on");charts_=A("div",{class:"signal-charts"});live=new Zl;signals=this.live;charts=[];window_s=Pb;fixed;now_s=NaN;listed="";frames;receive(e,t){this.live.receive(e,t)}needs(e){return this.live.names.some(t=>xa(t)===e)}look(e){let t=this.live.names;if(this.signals=this.live,this.fixed=void 0,e!==void 0){this.signals=new Zl(N2,0);for(let s of t)this.signals.choose(s);for(let{topic:s,message:r}of e)this.signals.receive(s,r);let n=(e.at(-1)?.time_s??0)-(e[0]?.time_s??0);this.window_s=Math.min(Math.max(n,gg),Jl)}else this.window_s=Pb;this.frames=e,this.rebuild()}show(e){this.now_s=e.get("/estimate")?.t_s??NaN,this.showList(),this.draw()}get range(){if(this.fixed!==void 0)return this.fixed;let e=Number.isFinite(this.now_s)?this.now_s:0,t=this.signals.names.map(s=>this.signals.of(s)?.first_s??NaN).filter(Number.isFinite),n=Math.max(e-this.window_s,Math.min(e,...t));return{from_s:n,to_s:Math.max(e,n+this.window_s)}}scale(e){if(this.fixed===void 0)this.window_s=Math.min(Math.max(this.window_s*e,gg),Jl);else{let{from_s:t,to_s:n}=this.fixed,s=Math.min(Math.max((n-t)*e/2,gg/20),Jl),r=(t+n)/2;this.fixed={from_s:r-s,to_s:r+s}}this.draw()}choose(e){!pg(xa(e))||this.live.names.length>=zd||(this.live.choose(e),this.signals!==this.live&&(this.signals.choose(e),this.signals.before(e,(this.frames??[]).filter(({topic:t})=>t===xa(e)).map(({message:t})=>t))),this.past(xa(e)).then(t=>{this.live.before(e,t)},()=>{}),this.rebuild())}drop(e){this.live.drop(e),this.signals.drop(e),this.rebuild()}rebuild(){let e=new Map;for(let t of this.live.names){let n=mg(t);e.set(n,[...e.get(n)??[],t])}for(let t of this.charts)t.destroy();this.charts=[...e].map(([t,n])=>new Bd(n,t,s=>{this.fixed=s,this.draw()})),this.charts_.replaceChildren(...this.charts.length===0?[A("p",{class:"empty"},`Choose up to ${zd} fields; those of one unit share a diagram. Drag over a diagram to see a part of the time.`)]:this.charts.map(t=>t.element)),localStorage.setItem(Lb,JSON.stringify(this.live.names)),this.listed="",this.showList(),this.draw()}draw(){if(Ne(this.pauseButton,this.fixed===void 0?"Pause":"Go on"),Ke(this.pauseButton,"aria-pressed",String(this.fixed!==void 0)),this.element.hidden)return;let e=this.range;for(let t of this.charts)t.show(this.signals,e,this.now_s)}showList(){let e=this.live.names,t=Eb([...new Set([...this.live.fields,...this.signals.fields,...e])].sort(),this.search.value.trim()),n=[...t.filter(r=>e.includes(r)),...t.filter(r=>!e.includes(r))].slice(0,D2),s=`${n.join()} ${e.join()} ${t.length}`;s!==this.listed&&(this.listed=s,Ne(this.chosen,`Fields (${e.length} chosen)`),this.list.replaceChildren(...n.map(r=>this.item(r,e)),...t.length>n.length?[A("li",{class:"empty"},`${t.length-n.length} more: search`)]:[]))}item(e,t){let n=A("input",{type:"checkbox","aria-label":e});n.checked=t.includes(e),n.disabled=!n.checked&&t.length>=zd,n.addEventListener("change",()=>{n.checked?this.choose(e):this.drop(e)});let s=mg(e);return A("li",{},A("label",{},n,e,...s===""?[]:[A("span",{class:"plot-unit"},s)]))}saveTable(){let{from_s:e,to_s:t}=this.range,n=this.live.names.map(s=>{let[r=new Float64Array,o=new Float64Array]=this.signals.of(s)?.since(-1/0)??[],a=[...r.keys()].filter(l=>(r[l]??NaN)>=e&&(r[l]??NaN)<=t);return{name:s,times:Float64Array.from(a,l=>r[l]??NaN),values:Float64Array.from(a,l=>o[l]??NaN)}});Rb("signals.csv",new Blob([Ab(n)],{type:"text/csv"}))}saveImage(){let e=this.charts[0]?.image;if(e===void 0)return;let t=devicePixelRatio,n=22*t,s=A("canvas");s.width=e.width,s.height=this.charts.reduce((a,{image:l})=>a+l.height+n,0);let r=s.getContext("2d");if(r===null)return;r.fillStyle="#0f151c",r.fillRect(0,0,s.width,s.height),r.font=`${12*t}px B612, sans-serif`,r.textBaseline="middle";let o=0;for(let a of this.charts){let l=8*t;a.names.forEach((c,h)=>{let u=`${c}${a.unit===""?"":` ${a.unit}`}`;r.fillStyle=a.colour(h),r.fillText(u,l,o+n/2),l+=r.measureText(u).width+16*t}),r.drawImage(a.image,0,o+n),o+=a.image.height+n}s.toBlob(a=>{a!==null&&Rb("signals.png",a)})}};function jl(i,e,t){return A("button",{type:"button",class:"control",id:i,title:t},e)}function Rb(i,e){let t=URL.createObjectURL(e);A("a",{href:t,download:i}).click(),setTimeout(()=>{URL.revokeObjectURL(t)},1e4)}function k2(){try{let i=JSON.parse(localStorage.getItem(Lb)??"[]");return Array.isArray(i)?i.filter(e=>typeof e=="string").slice(0,zd):[]}catch{return[]}}var ba=class{element;value=A("span",{class:"chip-value"});detail=A("span",{class:"chip-detail"});constructor(e,t){this.element=A("div",{class:"chip",id:`chip-${e}`,"data-lamp":"none"},A("span",{class:"chip-label"},t),this.value,this.detail)}show(e,t,n,s=""){Ke(this.element,"data-lamp",e),Ne(this.value,t),Ne(this.detail,n),Ke(this.element,"title",s)}},O2={idle:"none",arming:"wait",running:"good",finished:"done",aborted:"bad",driving:"good"},Gd=class{element=A("div",{class:"chips"});run=new ba("run","run");link=new ba("link","link");loop=new ba("loop","loop");viewers=new ba("viewers","viewers");constructor(){this.run.element.setAttribute("role","status"),this.element.append(this.run.element,this.link.element,this.loop.element,this.viewers.element)}show(e,t){this.showRun(e),this.showLink(e,t);let n=e.get("/loop");if(!t||n===void 0||e.stale("/loop"))this.loop.show("none","–","");else{let o=n.overruns+n.missed;this.loop.show(o>0?"warn":"good",`${at(n.rate_hz,0)} Hz`,`p99.9 ${qt(n.lateness_us.p999)}`,`${Bn(n.overruns)} overruns, ${Bn(n.missed)} missed cycles, paced by the ${n.pacing}`)}let s=e.get("/client"),r=s?.dropped_total??0;this.viewers.show(r>0?"warn":"none",t?at(s?.clients.length,0):"–",r>0?`${Bn(r)} dropped`:"","Browsers and other clients of this daemon")}showRun(e){let t=e.get("/state");if(t===void 0||e.stale("/state")){this.run.show("none",t?.run??"–","stale");return}let n=["arming","running","driving"].includes(t.run);if(t.motors_on&&!n){this.run.show("bad",t.run,"motors on","The motors are on, though no run is under way");return}let s=typeof t.run_s=="number"?Ii(t.run_s):"",r=t.run==="driving"&&t.driver?t.driver.by:s;this.run.show(O2[t.run]??"none",t.run,r,t.why_not_start)}showLink(e,t){let n=e.get("/link");if(!t){this.link.show("bad","no daemon","");return}if(n===void 0||e.stale("/link")){this.link.show("warn","silent","");return}let s=n.lost_hz+n.bad_hz,r=`${n.kind??"unknown"} robot on ${n.port}, firmware ${n.firmware??"unknown"}; ${Bn(n.counters.lost)} samples lost, ${Bn(n.counters.crc_errors)} CRC errors, ${Bn(n.counters.reconnects)} reconnects`;if(n.session!=="ready"){let o=n.quality==="lost"||n.session==="closed"||n.session==="refused";this.link.show(o?"bad":"wait",n.session,n.port,r);return}this.link.show(n.quality==="good"?"good":"warn",`${at(n.samples_hz,0)} Hz`,s>.05?`${at(s,1)} bad/s`:`rtt ${qt(n.round_trip_us)}`,r)}};var U2=3e3,Hd=class{element;line=A("span",{class:"stop-line"});constructor(e){this.element=A("button",{class:"stop",id:"stop",type:"button","data-state":"ready"});let t=A("span",{class:"stop-word"},hs("stop"),"STOP");this.element.append(t,this.line),this.line.setAttribute("role","status"),this.line.setAttribute("aria-live","assertive"),this.element.setAttribute("aria-keyshortcuts","Space Escape");let n=-1/0;this.element.addEventListener("pointerdown",s=>{n=s.timeStamp,e()}),this.element.addEventListener("click",s=>{(s.detail===0||s.timeStamp-n>U2)&&e()})}show(e){Ke(this.element,"data-state",e.kind),Ne(this.line,F2(e))}};function F2(i){switch(i.kind){case"ready":return"space or esc";case"pending":return"sent…";case"not_acknowledged":return i.waiting?"not acknowledged · no link":"not acknowledged";case"stopped":{let e=i.by===""||i.took_ms!==null?"":` · ${i.by}`;return i.took_ms===null?`stopped${e}`:`robot stopped in ${at(i.took_ms,i.took_ms<100?1:0)} ms`}}}function Ib(i,e){let n=(i.segments??[]).filter(({kind:s,from_m:r})=>s==="pivot"&&r>e).reduce((s,{angle_rad:r})=>s+Math.abs(r),0);return Math.max(i.length_m-e,0)/i.speed_mps+n/.6}function Db(i,e){if(i?.run!=="running"||e===void 0||!(e.length_m>0)||!(e.speed_mps>0)||(i.pause_left_s??0)>0)return;let t=Ib(e,i.progress_m??0),n=Ib(e,0)-t,s=i.run_s??0,r=n<3?1:Math.min(Math.max(s/n,.7),2);return t*r}var Wd=class{element=A("section",{class:"timeline","aria-label":"Progress"});name=A("span",{class:"timeline-name"});strip=A("div",{class:"strip"});fill=A("i",{class:"strip-fill"});marks=A("div",{class:"strip-marks"});time=A("output",{class:"timeline-time"});left=A("output",{class:"timeline-left",title:"Time that the run will about still take"});way=A("output",{class:"timeline-way"});courseShown=-1;constructor(){this.strip.append(this.fill,this.marks),this.element.append(this.name,this.strip,this.way,this.left,this.time)}show(e){let t=e.received["/course"]??0,n=e.get("/course");t!==this.courseShown&&(this.courseShown=t,this.build(n));let s=e.get("/state"),r=n?.length_m??0,o=s?.run==="idle"?0:e.get("/estimate")?.progress_m??0,l=`scaleX(${(r>0?Math.min(Math.max(o/r,0),1):0).toFixed(4)})`;this.fill.style.transform!==l&&(this.fill.style.transform=l),Ne(this.way,r>0?`${at(o,2)} / ${at(r,2)} m`:"–");let c=Db(s,n);Ne(this.left,c===void 0?"":`${Ii(Math.ceil(c)).replace(/\.\d$/,"")} left`),Ne(this.time,Ii(s?.run_s??0)),St(this.element,"stale",e.stale("/estimate"))}reset(){this.courseShown=-1}build(e){if(Ne(this.name,e===void 0||e.name===""?"no course":`course ${e.name}`),this.name.title=e?.description??"",this.marks.replaceChildren(),e===void 0||e.length_m<=0)return;let t=(n,s,r,o)=>{let a=A("i",{class:`mark ${r}`,title:o});a.style.left=`${(100*n/e.length_m).toFixed(2)}%`,a.style.width=`${(100*(s-n)/e.length_m).toFixed(2)}%`,this.marks.append(a)};for(let[n,s]of[["ramp",e.ramps],["block",e.blocks]])for(let r of s){let o=B2(e,r,"top_m"in r?r.top_m+.3:r.depth_m);o&&t(o[0],o[1],n,`${n}, ${at(1e3*r.height_m,0)} mm high`)}for(let n of e.disturbances)t(n.at_m,n.at_m+.01,"disturbance","somebody pushes the robot")}};function B2(i,e,t){let n=i.path.filter(o=>Math.hypot(o.x_m-e.x_m,o.y_m-e.y_m)<=t/2),s=n[0],r=n.at(-1);return s&&r?[s.s_m,r.s_m]:void 0}var _g=[1,2,4,.25],z2=.1,Xd=class{element=A("section",{class:"transport","aria-label":"Recording"});name=A("span",{class:"transport-name"});play=A("button",{type:"button",id:"play","aria-label":"Play"});slider=A("input",{type:"range",id:"scrub",min:"0",step:"0.01","aria-label":"Position in the recording, seconds"});time=A("output",{class:"transport-time"});speed=A("button",{type:"button","aria-label":"Speed"},"1×");player;shownPlaying;constructor(e){let t=A("button",{type:"button",id:"live",class:"transport-live"},"back to live");this.element.append(this.name,this.play,this.slider,this.time,this.speed,t),this.element.hidden=!0,this.play.addEventListener("click",()=>this.player?.toggle()),this.slider.addEventListener("input",()=>{this.player!==void 0&&(this.player.playing=!1,this.player.show(Number(this.slider.value)))}),this.speed.addEventListener("click",()=>{this.player!==void 0&&(this.player.speed=_g[(_g.indexOf(this.player.speed)+1)%_g.length]??1,Ne(this.speed,`${this.player.speed}×`))}),t.addEventListener("click",e)}loading(e,t){this.element.hidden=!1,Ne(this.name,`${e} · loading ${(100*t).toFixed(0)} %`)}open(e,t){this.player=t,this.element.hidden=!1,this.slider.max=t.duration_s.toFixed(2),Ne(this.speed,"1×"),Ne(this.name,e)}close(){this.player=void 0,this.element.hidden=!0}step(e){this.player!==void 0&&(this.player.playing=!1,this.player.show(this.player.position_s+e*z2))}show(){let e=this.player;if(e===void 0)return;let t=e.position_s.toFixed(2);this.slider.value!==t&&(this.slider.value=t),Ne(this.time,`${Ii(e.position_s)} / ${Ii(e.duration_s)}`),e.playing!==this.shownPlaying&&(this.shownPlaying=e.playing,this.play.replaceChildren(hs(e.playing?"pause":"play")),Ke(this.play,"aria-label",e.playing?"Pause":"Play"))}};var Nb={type:"change"},yg={type:"start"},Ob={type:"end"},qd=new Nr,kb=new vi,V2=Math.cos(70*Cp.DEG2RAD),Pn=new $,ui=2*Math.PI,Ct={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},vg=1e-6,$d=class extends fl{constructor(e,t=null){super(e,t),this.state=Ct.NONE,this.target=new $,this.cursor=new $,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:mr.ROTATE,MIDDLE:mr.DOLLY,RIGHT:mr.PAN},this.touches={ONE:gr.ROTATE,TWO:gr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new $,this._lastQuaternion=new ni,this._lastTargetPosition=new $,this._quat=new ni().setFromUnitVectors(e.up,new $(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Wo,this._sphericalDelta=new Wo,this._scale=1,this._panOffset=new $,this._rotateStart=new et,this._rotateEnd=new et,this._rotateDelta=new et,this._panStart=new et,this._panEnd=new et,this._panDelta=new et,this._dollyStart=new et,this._dollyEnd=new et,this._dollyDelta=new et,this._dollyDirection=new $,this._mouse=new et,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=H2.bind(this),this._onPointerDown=G2.bind(this),this._onPointerUp=W2.bind(this),this._onContextMenu=J2.bind(this),this._onMouseWheel=$2.bind(this),this._onKeyDown=Y2.bind(this),this._onTouchStart=K2.bind(this),this._onTouchMove=Z2.bind(this),this._onMouseDown=X2.bind(this),this._onMouseMove=q2.bind(this),this._interceptControlDown=j2.bind(this),this._interceptControlUp=Q2.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ct.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Nb),this.update(),this.state=Ct.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Pn.copy(t).sub(this.target),Pn.applyQuaternion(this._quat),this._spherical.setFromVector3(Pn),this.autoRotate&&this.state===Ct.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ui:n>Math.PI&&(n-=ui),s<-Math.PI?s+=ui:s>Math.PI&&(s-=ui),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Pn.setFromSpherical(this._spherical),Pn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Pn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Pn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new $(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new $(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Pn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(qd.origin.copy(this.object.position),qd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(qd.direction))<V2?this.object.lookAt(this.target):(kb.setFromNormalAndCoplanarPoint(this.object.up,this.target),qd.intersectPlane(kb,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>vg||8*(1-this._lastQuaternion.dot(this.object.quaternion))>vg||this._lastTargetPosition.distanceToSquared(this.target)>vg?(this.dispatchEvent(Nb),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ui/60*this.autoRotateSpeed*e:ui/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Pn.setFromMatrixColumn(t,0),Pn.multiplyScalar(-e),this._panOffset.add(Pn)}_panUp(e,t){this.screenSpacePanning===!0?Pn.setFromMatrixColumn(t,1):(Pn.setFromMatrixColumn(t,0),Pn.crossVectors(this.object.up,Pn)),Pn.multiplyScalar(e),this._panOffset.add(Pn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Pn.copy(s).sub(this.target);let r=Pn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ui*this._rotateDelta.x/t.clientHeight),this._rotateUp(ui*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ui*this._rotateDelta.x/t.clientHeight),this._rotateUp(ui*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new et,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function G2(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function H2(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function W2(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Ob),this.state=Ct.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function X2(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case mr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ct.DOLLY;break;case mr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ct.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ct.ROTATE}break;case mr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ct.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ct.PAN}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(yg)}function q2(i){switch(this.state){case Ct.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ct.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ct.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function $2(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ct.NONE||(i.preventDefault(),this.dispatchEvent(yg),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Ob))}function Y2(i){this.enabled!==!1&&this._handleKeyDown(i)}function K2(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case gr.ROTATE:if(this.enableRotate===!1){this.state=Ct.NONE;break}this._handleTouchStartRotate(i),this.state=Ct.TOUCH_ROTATE;break;case gr.PAN:if(this.enablePan===!1){this.state=Ct.NONE;break}this._handleTouchStartPan(i),this.state=Ct.TOUCH_PAN;break;default:this.state=Ct.NONE}break;case 2:switch(this.touches.TWO){case gr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ct.TOUCH_DOLLY_PAN;break;case gr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ct.TOUCH_DOLLY_ROTATE;break;default:this.state=Ct.NONE}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(yg)}function Z2(i){switch(this._trackPointer(i),this.state){case Ct.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ct.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ct.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ct.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ct.NONE}}function J2(i){this.enabled!==!1&&i.preventDefault()}function j2(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Q2(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var xg=["chase","top","free"],Ub=.52,eL=.29,Fb=.16,tL=.5,nL=.18,Yd=class{constructor(e,t){this.taken=t;this.camera.up.set(0,0,1),this.controls=new $d(this.camera,e),this.controls.enableDamping=!1,this.controls.maxPolarAngle=Math.PI/2-.02,this.controls.minDistance=.15,this.controls.maxDistance=8,this.controls.zoomToCursor=!0,this.controls.addEventListener("start",()=>{this.mode_!=="free"&&(this.mode_="free",this.taken())}),this.controls.addEventListener("change",()=>{this.moved=!0}),this.overview()}taken;camera=new ei(40,1,.02,60);controls;mode_="free";heading_rad=0;box={min_x:-1,max_x:1,min_y:-1,max_y:1};moved=!0;wantedEye=new $;wantedTarget=new $;get mode(){return this.mode_}set(e){e==="free"&&this.mode_==="free"&&this.overview(),this.mode_=e,this.moved=!0}frame(e){this.box=e,this.mode_==="free"&&this.overview(),this.moved=!0}resize(e){this.camera.aspect=e,this.camera.updateProjectionMatrix(),this.mode_==="free"&&this.overview(),this.moved=!0}update(e,t){this.mode_==="chase"&&e!==void 0?this.chase(e,t):this.mode_==="top"&&this.above(t);let n=this.moved;return this.moved=!1,n}overview(){let{x:e,y:t,reach:n}=this.middle(),s=n*1.02;this.controls.target.set(e,t,0),this.camera.position.set(e+.16*s,t-.78*s,.72*s),this.controls.update()}chase(e,t){let n=Math.atan2(Math.sin(e.yaw_rad-this.heading_rad),Math.cos(e.yaw_rad-this.heading_rad));this.heading_rad+=n*(1-Math.exp(-t/tL));let s=Math.cos(this.heading_rad),r=Math.sin(this.heading_rad);this.wantedEye.set(e.x_m-Ub*s,e.y_m-Ub*r,e.z_m+eL),this.wantedTarget.set(e.x_m+Fb*s,e.y_m+Fb*r,e.z_m+.03),this.glide(t)}above(e){let{x:t,y:n,height:s}=this.middle();this.wantedEye.set(t,n-.002,s),this.wantedTarget.set(t,n,0),this.glide(e)}glide(e){let t=1-Math.exp(-e/nL),{position:n}=this.camera;n.distanceToSquared(this.wantedEye)+this.controls.target.distanceToSquared(this.wantedTarget)<1e-9||(n.lerp(this.wantedEye,t),this.controls.target.lerp(this.wantedTarget,t),this.camera.lookAt(this.controls.target),this.moved=!0)}middle(){let{min_x:e,max_x:t,min_y:n,max_y:s}=this.box,r=Math.tan(this.camera.fov*Math.PI/360),o=t-e+.25,a=s-n+.25,l=Math.max(a,o/this.camera.aspect)/(2*r),c=Math.max(o/this.camera.aspect,a*.85)/(2*r)+.3;return{x:(e+t)/2,y:(n+s)/2,reach:c,height:l}}};var Kd=3e-4,bg=.001,wa=class{poses=[];tracks_m=[];points=[];check(e){let t=e.get("/estimate"),n=si.map(a=>t?.[a]??void 0),s=[e.leftTrack_m,e.rightTrack_m],r=si.map(a=>e.path_histories[a].length);return this.poses.length>0&&n.every((a,l)=>iL(a,this.poses[l]))&&s.every((a,l)=>Math.abs(a-(this.tracks_m[l]??NaN))<Kd)&&r.every((a,l)=>a===this.points[l])?!1:(this.poses=n,this.tracks_m=s,this.points=r,!0)}reset(){this.poses=[]}};function iL(i,e){return i===void 0||e===void 0?i===e:Math.abs(i.x_m-e.x_m)<Kd&&Math.abs(i.y_m-e.y_m)<Kd&&Math.abs(i.z_m-e.z_m)<Kd&&Math.abs(i.roll_rad-e.roll_rad)<bg&&Math.abs(i.pitch_rad-e.pitch_rad)<bg&&Math.abs(i.yaw_rad-e.yaw_rad)<bg}var Bb=.12,sL=.02;function rL(i,e,t){let n=i.max_x-i.min_x+2*Bb,s=i.max_y-i.min_y+2*Bb,r=Math.min(e/n,t/s);return{scale:r,left:e/2-r*(i.min_x+i.max_x)/2,top:t/2+r*(i.min_y+i.max_y)/2}}var ts=class{element=document.createElement("canvas");ground=document.createElement("canvas");visible={model:!0,odometry:!0,fused:!0,truth:!0};course;frame;projection={scale:100,left:0,top:0};ratio=1;moved=new wa;setCourse(e,t){this.course=e,this.frame=t,this.paintGround()}setCamera(e){this.moved.reset()}show(e,t){this.visible[e]=t,this.moved.reset()}resize(){let{clientWidth:e,clientHeight:t}=this.element.parentElement??this.element;e===0||t===0||(this.ratio=Math.min(window.devicePixelRatio,2),this.element.width=this.ground.width=Math.round(e*this.ratio),this.element.height=this.ground.height=Math.round(t*this.ratio),this.paintGround())}draw(e){let t=e.get("/estimate"),n=this.element.getContext("2d");if(n===null||!this.moved.check(e))return;n.setTransform(1,0,0,1,0,0),n.drawImage(this.ground,0,0);for(let r of si){if(!this.visible[r])continue;let o=e.path_histories[r].coordinates;n.strokeStyle=Ni[r],n.lineWidth=2*this.ratio,n.lineJoin="round",n.beginPath();for(let a=0;a<o.length;a+=3){let l=this.pixel(o[a]??0,o[a+1]??0);n.lineTo(l.x,l.y)}n.stroke()}if(t===void 0)return;for(let r of si){let o=t[r];!o||r===t.steering||!this.visible[r]||(this.polygon(n,Ys(oL(o),this.shape.length_m,this.shape.width_m)),n.strokeStyle=Ni[r],n.lineWidth=1.5*this.ratio,n.stroke())}let s=t[t.steering];this.robot(n,s,e.leftTrack_m,e.rightTrack_m),this.element.dataset.robot=[s.x_m,s.y_m,s.z_m,s.yaw_rad].join(" ")}reset(){this.moved.reset()}dispose(){this.element.remove()}world(e){let{scale:t,left:n,top:s}=this.projection;return{x:(e.x*this.ratio-n)/t,y:(s-e.y*this.ratio)/t}}point(e){let{x:t,y:n}=this.pixel(e.x,e.y);return{x:t/this.ratio,y:n/this.ratio}}get shape(){return this.course?.robot??Wr}pixel(e,t){let{scale:n,left:s,top:r}=this.projection;return{x:s+n*e,y:r-n*t}}polygon(e,t){e.beginPath();for(let{x:n,y:s}of t){let r=this.pixel(n,s);e.lineTo(r.x,r.y)}e.closePath()}robot(e,t,n,s){let{axle_spacing_m:r,wheel_radius_m:o,gauge_m:a,shoe_width_m:l}=this.shape,c=this.pixel(t.x_m,t.y_m);e.save(),e.translate(c.x,c.y),e.scale(this.projection.scale,-this.projection.scale),e.rotate(t.yaw_rad);let h=r+2*o;e.fillStyle="#c9d1da",e.fillRect(-.42*h,-(a-l)/2,.84*h,a-l),e.fillStyle="#fff3c4",e.fillRect(.42*h-.008,-.03,.008,.06);let u=jo(r,o),d=Math.round(u/sL);for(let[f,g]of[[1,n],[-1,s]]){let y=f*a/2-l/2;e.fillStyle="#05080b",e.fillRect(-h/2,y,h,l),e.fillStyle="#5b6672";for(let p=0;p<d;p++){let m=hu(r,o,p*u/d-g);m.y>o&&e.fillRect(m.x-.003,y,.006,l)}}e.restore()}paintGround(){let e=this.ground.getContext("2d");if(e===null)return;let{width:t,height:n}=this.ground;this.projection=rL(this.frame??yr(this.course),t,n),this.moved.reset(),e.fillStyle=Ju,e.fillRect(0,0,t,n),this.grid(e);let s=this.course;if(s!==void 0){for(let r of s.surfaces)this.polygon(e,Ys(r,r.length_m,r.width_m)),e.fillStyle=oa,e.fill();e.strokeStyle=Bl,e.lineWidth=this.ratio;for(let r of s.ramps){this.polygon(e,Ys(r,Qo(r),r.width_m)),e.fillStyle=Sr,e.fill(),e.stroke();let o=r.height_m/Math.tan(r.up_rad);for(let a of[o-Qo(r)/2,o+r.top_m-Qo(r)/2])this.across(e,r,a,r.width_m)}for(let r of s.blocks)this.polygon(e,Ys(r,r.depth_m,r.width_m)),e.fillStyle=Sr,e.fill(),e.stroke();e.strokeStyle=ed;for(let r of uu(s))this.polygon(e,r),e.fillStyle=Dy,e.fill(),e.stroke();this.polygon(e,Tl(s)),e.stroke(),e.setLineDash([6*this.ratio,5*this.ratio]),e.strokeStyle=Ji,e.lineWidth=1.5*this.ratio,e.beginPath();for(let r of s.path){let o=this.pixel(r.x_m,r.y_m);e.lineTo(o.x,o.y)}e.stroke(),e.setLineDash([])}}across(e,t,n,s){let r=Math.cos(t.heading_rad),o=Math.sin(t.heading_rad);e.beginPath();for(let a of[-s/2,s/2]){let l=this.pixel(t.x_m+r*n-o*a,t.y_m+o*n+r*a);e.lineTo(l.x,l.y)}e.stroke()}grid(e){let{scale:t,left:n,top:s}=this.projection,{width:r,height:o}=this.ground,a=.1;e.lineWidth=1;let l=(c,h,u,d,f)=>{e.strokeStyle=c?Qu:ju,e.beginPath(),e.moveTo(Math.round(h)+.5,Math.round(u)+.5),e.lineTo(Math.round(d)+.5,Math.round(f)+.5),e.stroke()};for(let c=Math.ceil(-n/t/a);c*a*t+n<r;c++)l(c%5===0,n+c*a*t,0,n+c*a*t,o);for(let c=Math.ceil((s-o)/t/a);c*a*t<s;c++)l(c%5===0,0,s-c*a*t,r,s-c*a*t)}},oL=i=>({x_m:i.x_m,y_m:i.y_m,heading_rad:i.yaw_rad});var Sa=class{constructor(e,t,n,s){this.capacity=e;this.width_m=n;this.lift_m=s;this.vertices=new Float32Array(6*e),this.attribute=new Un(this.vertices,3),this.indices=new Uint32Array(6*e);for(let a=0;a+1<e;a++)this.indices.set(zb(a),6*a);let r=new Gn;r.setAttribute("position",this.attribute),r.setIndex(new Un(this.indices,1)),r.setDrawRange(0,0);let o=new cr({color:t,side:ai,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-4});this.mesh=new en(r,o),this.mesh.frustumCulled=!1}capacity;width_m;lift_m;mesh;vertices;attribute;indices;shown=0;generation=-1;follow(e){if(e.generation===this.generation&&e.length===this.shown)return!1;let t=e.generation===this.generation?Math.max(this.shown-1,0):0;return this.generation=e.generation,this.show(e.coordinates,t),!0}set(e,t=0){let n=Math.min(e.length/3,this.capacity);for(let r=0;r+1<this.capacity;r++){let o=t>0&&Math.floor(r/t)%2===1;this.indices.set(o?[0,0,0,0,0,0]:zb(r),6*r)}let s=this.mesh.geometry.getIndex();s!==null&&(s.needsUpdate=!0),this.show(e.subarray(0,3*n),0)}reset(){this.generation=-1}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}show(e,t){let n=e.length/3;lv(e,t,n,this.width_m,this.lift_m,this.vertices),this.attribute.clearUpdateRanges(),n>t&&this.attribute.addUpdateRange(6*t,6*(n-t)),this.attribute.needsUpdate=!0,this.mesh.geometry.setDrawRange(0,6*Math.max(n-1,0)),this.shown=n}},zb=i=>[2*i,2*i+1,2*i+2,2*i+1,2*i+3,2*i+2];var Vb=1.2,aL=.006,lL=5,Zd=class{group=new Ci;path;set(e){if(this.path?.dispose(),this.path=void 0,El(this.group),this.floor(e),e!==void 0){for(let t of e.surfaces){let n=new en(new ps(t.length_m,t.width_m),new Xi({color:oa,polygonOffset:!0,polygonOffsetFactor:-1}));n.receiveShadow=!0,wg(n,t),n.position.z=6e-4,this.group.add(n)}for(let t of e.ramps){let n=Hr(Yp(t),t.width_m,Sr,Bl);wg(n,t),this.group.add(n)}for(let t of e.blocks){let n=Hr(rv(t),t.width_m,Sr,Bl);wg(n,t),this.group.add(n)}for(let t of[Tl(e),...uu(e)]){let n=t.flatMap(({x:s,y:r})=>[s,r,.001]);n.length>0&&this.group.add(new nl(Sg(n),new Pi({color:ed})))}if(e.path.length>1){let t=av(e);this.path=new Sa(t.length/3,Ji,aL,.0015),this.path.set(t,lL),this.group.add(this.path.mesh,Gb(e.path[0],.014,.02),Gb(e.path.at(-1),.02,.03))}}}floor(e){let t=yr(e),n=.1,s=y=>Math.floor((y-Vb)/n)*n,r=y=>Math.ceil((y+Vb)/n)*n,[o,a,l,c]=[s(t.min_x),r(t.max_x),s(t.min_y),r(t.max_y)],h=new en(new ps(40,40),new Xi({color:Ju,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}));h.position.set((o+a)/2,(l+c)/2,0),h.receiveShadow=!0;let u=[],d=[],f=(y,p,m)=>{for(let x=Math.round(y/n);x<=Math.round(p/n);x++)(x%5===0?d:u).push(...m(x*n))},g=(y,p,m)=>{let x=[];for(let C=Math.round(y/n);C<Math.round(p/n);C+=5)x.push(...m(C*n,Math.min((C+5)*n,p)));return x};f(o,a,y=>g(l,c,(p,m)=>[y,p,0,y,m,0])),f(l,c,y=>g(o,a,(p,m)=>[p,y,0,m,y,0])),this.group.add(h,new Wi(Sg(u),new Pi({color:ju})),new Wi(Sg(d),new Pi({color:Qu})))}};function wg(i,e){i.position.set(e.x_m,e.y_m,0),i.rotation.z=e.heading_rad}function Sg(i){let e=new Gn;return e.setAttribute("position",new Un(new Float32Array(i),3)),e}function Gb(i,e,t){let n=new en(new ol(e,t,32),new cr({color:Ji,side:ai,polygonOffset:!0,polygonOffsetFactor:-2}));return n.position.set(i?.x_m??0,i?.y_m??0,.001),n}var Jd=class{drawn_ms=-1/0;free_ms=-1/0;slow=0;waiting=!1;level=0;tick(e){if(this.waiting){this.waiting=!1;let t=e-this.drawn_ms;this.free_ms=t>45?e+t*(1/.5-1):-1/0,this.slow=t>45?this.slow+1:Math.max(0,this.slow-1),this.slow>40&&this.level<2&&(this.level++,this.slow=0)}return e>=this.free_ms}drawn(e){this.drawn_ms=e,this.waiting=!0}};var cL=.007,hL={model:.002,odometry:.0025,fused:.003,truth:.0035},uL=2,jd=class{element;renderer;scene=new Za;rig;sun=new dl("#ffffff",2.2);course=new Zd;ribbons;ghosts;robot;shape=Wr;visible={model:!0,odometry:!0,fused:!0,truth:!0};pace=new Jd;level=0;lag_s=0;moved=new wa;changed=!0;constructor(e,t){this.renderer=new ou({antialias:!0,powerPreference:"low-power"}),this.element=this.renderer.domElement,this.element.addEventListener("webglcontextlost",t),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=Ur,this.scene.background=new ut(Cm),this.scene.fog=new Ka(Cm,3.5,9),this.scene.add(new cl("#bcd6f5","#26303c",1.4),this.sun,this.sun.target,this.course.group),this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.bias=-4e-4,this.sun.shadow.normalBias=.002,this.rig=new Yd(this.element,e),this.ribbons=Hb(n=>new Sa(4e3,Ni[n],cL,hL[n]));for(let n of si)this.scene.add(this.ribbons[n].mesh);this.robot=new Al(this.shape),this.ghosts=this.makeGhosts(),this.scene.add(this.robot.group),this.setCourse(void 0)}setCourse(e){this.course.set(e);let t=yr(e);this.rig.frame(t);let n=(t.min_x+t.max_x)/2,s=(t.min_y+t.max_y)/2,r=Math.hypot(t.max_x-t.min_x,t.max_y-t.min_y)/2+.2;this.sun.target.position.set(n,s,0),this.sun.position.set(n-.6*r,s-.35*r,1.4*r);let o=this.sun.shadow.camera;if([o.left,o.right,o.bottom,o.top]=[-r,r,-r,r],[o.near,o.far]=[.1,4*r],o.updateProjectionMatrix(),e!==void 0&&JSON.stringify(e.robot)!==JSON.stringify(this.shape)){this.shape=e.robot;for(let a of[this.robot,...Object.values(this.ghosts)])this.scene.remove(a.group),El(a.group);this.robot=new Al(this.shape),this.scene.add(this.robot.group),this.ghosts=this.makeGhosts()}this.moved.reset(),this.changed=!0}setCamera(e){this.rig.set(e),this.changed=!0}show(e,t){this.visible[e]=t,this.moved.reset()}draw(e,t){let n=performance.now();if(this.lag_s+=t,!this.pace.tick(n))return;this.degrade();for(let l of si){let c=this.ribbons[l];c.follow(e.path_histories[l])&&(this.changed=!0),c.mesh.visible=this.visible[l]}let s=e.get("/estimate");if(this.moved.check(e)){this.changed=!0,this.robot.group.visible=s!==void 0,s!==void 0&&this.robot.set(s[s.steering],e.leftTrack_m,e.rightTrack_m);for(let l of si){let c=s?.[l],h=this.ghosts[l];h.group.visible=!!c&&l!==s.steering&&this.visible[l],c&&h.set(c)}}let r=this.rig.update(e.pose,this.lag_s);if(this.lag_s=0,!r&&!this.changed)return;this.changed=!1,this.renderer.render(this.scene,this.rig.camera),this.pace.drawn(n);let{position:o,rotation:a}=this.robot.group;s!==void 0&&(this.element.dataset.robot=[o.x,o.y,o.z,a.z].join(" "))}reset(){this.moved.reset();for(let e of si)this.ribbons[e].reset()}resize(){let{clientWidth:e,clientHeight:t}=this.element.parentElement??this.element;e===0||t===0||(this.renderer.setPixelRatio(this.level>1?.6:Math.min(window.devicePixelRatio,uL)),this.renderer.setSize(e,t),this.rig.resize(e/t),this.changed=!0)}dispose(){El(this.scene),this.renderer.dispose(),this.element.remove()}degrade(){this.pace.level!==this.level&&(this.level=this.pace.level,this.sun.castShadow=!1,this.level>1&&this.resize())}makeGhosts(){return Hb(e=>{let t=new du(this.shape,Ni[e]);return t.group.visible=!1,this.scene.add(t.group),t})}};function Hb(i){return{model:i("model"),odometry:i("odometry"),fused:i("fused"),truth:i("truth")}}var Qd=[...xg,"map"],ef=class{element=A("section",{class:"viewport","aria-label":"Course"});stage=A("div",{class:"stage"});buttons=new Map;toggles=new Map;hidden=new Set;view;mode="free";webgl=!0;course;courseShown=-1;drafted=!1;frame;constructor(){let e=A("div",{class:"modes",role:"group","aria-label":"Camera"});for(let o of Qd){let a=A("button",{type:"button","aria-pressed":"false",id:`camera-${o}`},o);a.addEventListener("click",()=>{this.set(o)}),this.buttons.set(o,a),e.append(a)}let t=A("div",{class:"key",role:"group","aria-label":"Paths"}),n=A("i",{class:"swatch dashed"});n.style.color=Ji,t.append(A("span",{class:"key-item"},n,"plan"));for(let o of si){let a=A("i",{class:"swatch"});a.style.color=Ni[o];let l=A("button",{type:"button",class:"key-item","aria-pressed":"true",id:`show-${o}`},a,o);l.addEventListener("click",()=>{this.toggle(o)}),this.toggles.set(o,l),t.append(l)}this.element.append(this.stage,t,e);let s=dL();s==="nothing"&&this.withoutWebgl();let r=s==="card"?"free":"map";this.view=this.make(r),this.set(this.view instanceof ts?"map":r),new ResizeObserver(()=>{this.view.resize()}).observe(this.stage)}set(e){if(e!=="map"&&!this.webgl)return;this.view instanceof ts!==(e==="map")&&(this.view.dispose(),this.view=this.make(e)),this.mode=this.view instanceof ts?"map":e,this.mode!=="map"&&this.view.setCamera(this.mode),this.mark()}next(){let e=this.webgl?Qd:["map"];this.set(e[(e.indexOf(this.mode)+1)%e.length]??"map")}world(e){return this.view instanceof ts?this.view.world(e):void 0}pixel(e){return this.view instanceof ts?this.view.point(e):void 0}draft(e,t){this.drafted=e!==void 0,this.frame=t,e===void 0?this.courseShown=-1:this.setCourse(e)}setCourse(e){this.course=e,this.view instanceof ts?this.view.setCourse(e,this.frame):this.view.setCourse(e)}draw(e,t){let n=e.received["/course"]??0;n!==this.courseShown&&!this.drafted&&(this.courseShown=n,this.setCourse(e.get("/course")));let s=this.toggles.get("truth");s&&St(s,"absent",!e.get("/estimate")?.truth),St(this.element,"stale",e.stale("/estimate")),this.view.draw(e,t)}reset(){this.courseShown=-1,this.view.reset()}toggle(e){this.hidden.delete(e)||this.hidden.add(e);let t=!this.hidden.has(e);this.view.show(e,t);let n=this.toggles.get(e);n&&Ke(n,"aria-pressed",String(t))}make(e){let t=this.scene(e)??new ts;this.stage.replaceChildren(t.element),t.element.setAttribute("aria-hidden","true"),t.resize(),t instanceof ts?t.setCourse(this.course,this.frame):t.setCourse(this.course);for(let n of this.hidden)t.show(n,!1);return t}scene(e){if(!(e==="map"||!this.webgl))try{return new jd(()=>{this.mode="free",this.mark()},()=>{this.withoutWebgl(),this.set("map")})}catch{this.withoutWebgl();return}}withoutWebgl(){this.webgl=!1;for(let e of xg){let t=this.buttons.get(e);t!==void 0&&(t.disabled=!0,t.title="This browser has no WebGL")}}mark(){for(let[e,t]of this.buttons)Ke(t,"aria-pressed",String(e===this.mode))}};function dL(){let i=document.createElement("canvas").getContext("webgl2");if(i===null)return"nothing";let e=i.getExtension("WEBGL_debug_renderer_info"),t=String(i.getParameter(e?.UNMASKED_RENDERER_WEBGL??i.RENDERER));return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)?"processor":"card"}var tf=class{constructor(e,t){this.frames=e;this.store=t;this.begin_s=e.find(n=>n.topic==="/estimate")?.time_s??0,this.end_s=e.at(-1)?.time_s??0,this.at_s=this.begin_s,this.seek(this.begin_s)}frames;store;begin_s;end_s;playing=!1;speed=1;next=0;at_s;get duration_s(){return this.end_s-this.begin_s}get position_s(){return this.at_s-this.begin_s}get began_unix_s(){let e=this.frames.find(n=>n.topic==="/estimate"),t=(e?.time_s??0)-(e?.message?.t_s??0);return t>1e9?t:void 0}seek(e){let t=Math.min(Math.max(e,this.begin_s),this.end_s);t<this.at_s&&(this.next=0,this.store.clear()),this.at_s=t;for(let n=this.frames[this.next];n!==void 0&&n.time_s<=t;n=this.frames[++this.next])this.store.receive(n.topic,n.message)}show(e){this.seek(this.begin_s+e)}tick(e){if(this.playing){if(this.at_s>=this.end_s){this.playing=!1;return}this.seek(this.at_s+e*this.speed)}}toggle(){!this.playing&&this.at_s>=this.end_s&&this.seek(this.begin_s),this.playing=!this.playing}};var fL=ArrayBuffer,un=Uint8Array,nf=Uint16Array,pL=Int16Array;var sf=Int32Array,Mg=function(i,e,t){if(un.prototype.slice)return un.prototype.slice.call(i,e,t);(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length);var n=new un(t-e);return n.set(i.subarray(e,t)),n},ec=function(i,e,t,n){if(un.prototype.fill)return un.prototype.fill.call(i,e,t,n);for((t==null||t<0)&&(t=0),(n==null||n>i.length)&&(n=i.length);t<n;++t)i[t]=e;return i},mL=function(i,e,t,n){if(un.prototype.copyWithin)return un.prototype.copyWithin.call(i,e,t,n);for((t==null||t<0)&&(t=0),(n==null||n>i.length)&&(n=i.length);t<n;)i[e++]=i[t++]};var gL=["invalid zstd data","window size too large (>2046MB)","invalid block type","FSE accuracy too high","match distance too far back","unexpected EOF"],wn=function(i,e,t){var n=new Error(e||gL[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,wn),!t)throw n;return n},Wb=function(i,e,t){for(var n=0,s=0;n<t;++n)s|=i[e++]<<(n<<3);return s},_L=function(i,e){return(i[e]|i[e+1]<<8|i[e+2]<<16|i[e+3]<<24)>>>0},vL=function(i,e){var t=i[0]|i[1]<<8|i[2]<<16;if(t==3126568&&i[3]==253){var n=i[4],s=n>>5&1,r=n>>2&1,o=n&3,a=n>>6;n&8&&wn(0);var l=6-s,c=o==3?4:o,h=Wb(i,l,c);l+=c;var u=a?1<<a:s,d=Wb(i,l,u)+(a==1&&256),f=d;if(!s){var g=1<<10+(i[5]>>3);f=g+(g>>3)*(i[5]&7)}f>2145386496&&wn(1);var y=new un((e==1?d||f:e?0:f)+12);return y[0]=1,y[4]=4,y[8]=8,{b:l+u,y:0,l:0,d:h,w:e&&e!=1?e:y.subarray(12),e:f,o:new sf(y.buffer,0,3),u:d,c:r,m:Math.min(131072,f)}}else if((t>>4|i[3]<<20)==25481893)return _L(i,4)+8;wn(0)},so=function(i){for(var e=0;1<<e<=i;++e);return e-1},tc=function(i,e,t){var n=(e<<3)+4,s=(i[e]&15)+5;s>t&&wn(3);for(var r=1<<s,o=r,a=-1,l=-1,c=-1,h=r,u=new fL(512+(r<<2)),d=new pL(u,0,256),f=new nf(u,0,256),g=new nf(u,512,r),y=512+(r<<1),p=new un(u,y,r),m=new un(u,y+r);a<255&&o>0;){var x=so(o+1),C=n>>3,M=(1<<x+1)-1,R=(i[C]|i[C+1]<<8|i[C+2]<<16)>>(n&7)&M,T=(1<<x)-1,v=M-o-1,E=R&T;if(E<v?(n+=x,R=E):(n+=x+1,R>T&&(R-=v)),d[++a]=--R,R==-1?(o+=R,p[--h]=a):o-=R,!R)do{var z=n>>3;l=(i[z]|i[z+1]<<8)>>(n&7)&3,n+=2,a+=l}while(l==3)}(a>255||o)&&wn(0);for(var k=0,N=(r>>1)+(r>>3)+3,W=r-1,H=0;H<=a;++H){var I=d[H];if(I<1){f[H]=-I;continue}for(c=0;c<I;++c){p[k]=H;do k=k+N&W;while(k>=h)}}for(k&&wn(0),c=0;c<r;++c){var F=f[p[c]]++,q=m[c]=s-so(F);g[c]=(F<<q)-r}return[n+7>>3,{b:s,s:p,n:m,t:g}]},yL=function(i,e){var t=0,n=-1,s=new un(292),r=i[e],o=s.subarray(0,256),a=s.subarray(256,268),l=new nf(s.buffer,268);if(r<128){var c=tc(i,e+1,6),h=c[0],u=c[1];e+=r;var d=h<<3,f=i[e];f||wn(0);for(var g=0,y=0,p=u.b,m=p,x=(++e<<3)-8+so(f);x-=p,!(x<d);){var C=x>>3;if(g+=(i[C]|i[C+1]<<8)>>(x&7)&(1<<p)-1,o[++n]=u.s[g],x-=m,x<d)break;C=x>>3,y+=(i[C]|i[C+1]<<8)>>(x&7)&(1<<m)-1,o[++n]=u.s[y],p=u.n[g],g=u.t[g],m=u.n[y],y=u.t[y]}++n>255&&wn(0)}else{for(n=r-127;t<n;t+=2){var M=i[++e];o[t]=M>>4,o[t+1]=M&15}++e}var R=0;for(t=0;t<n;++t){var T=o[t];T>11&&wn(0),R+=T&&1<<T-1}var v=so(R)+1,E=1<<v,z=E-R;for(z&z-1&&wn(0),o[n++]=so(z)+1,t=0;t<n;++t){var T=o[t];++a[o[t]=T&&v+1-T]}var k=new un(E<<1),N=k.subarray(0,E),W=k.subarray(E);for(l[v]=0,t=v;t>0;--t){var H=l[t];ec(W,t,H,l[t-1]=H+a[t]*(1<<v-t))}for(l[0]!=E&&wn(0),t=0;t<n;++t){var I=o[t];if(I){var F=l[I];ec(N,t,F,l[I]=F+(1<<v-I))}}return[e,{n:W,b:v,s:N}]},xL=tc(new un([81,16,99,140,49,198,24,99,12,33,196,24,99,102,102,134,70,146,4]),0,6)[1],bL=tc(new un([33,20,196,24,99,140,33,132,16,66,8,33,132,16,66,8,33,68,68,68,68,68,68,68,68,36,9]),0,6)[1],wL=tc(new un([32,132,16,66,102,70,68,68,68,68,36,73,2]),0,5)[1],Xb=function(i,e){for(var t=i.length,n=new sf(t),s=0;s<t;++s)n[s]=e,e+=1<<i[s];return n},Tg=new un(new sf([0,0,0,0,16843009,50528770,134678020,202050057,269422093]).buffer,0,36),SL=Xb(Tg,0),Eg=new un(new sf([0,0,0,0,0,0,0,0,16843009,50528770,117769220,185207048,252579084,16]).buffer,0,53),ML=Xb(Eg,3),Ql=function(i,e,t){var n=i.length,s=e.length,r=i[n-1],o=(1<<t.b)-1,a=-t.b;r||wn(0);for(var l=0,c=t.b,h=(n<<3)-8+so(r)-c,u=-1;h>a&&u<s;){var d=h>>3,f=(i[d]|i[d+1]<<8|i[d+2]<<16)>>(h&7);l=(l<<c|f)&o,e[++u]=t.s[l],h-=c=t.n[l]}(h!=a||u+1!=s)&&wn(0)},TL=function(i,e,t){var n=6,s=e.length,r=s+3>>2,o=r<<1,a=r+o;Ql(i.subarray(n,n+=i[0]|i[1]<<8),e.subarray(0,r),t),Ql(i.subarray(n,n+=i[2]|i[3]<<8),e.subarray(r,o),t),Ql(i.subarray(n,n+=i[4]|i[5]<<8),e.subarray(o,a),t),Ql(i.subarray(n),e.subarray(a),t)},EL=function(i,e,t){var n,s=e.b,r=i[s],o=r>>1&3;e.l=r&1;var a=r>>3|i[s+1]<<5|i[s+2]<<13,l=(s+=3)+a;if(o==1)return s>=i.length?void 0:(e.b=s+1,t?(ec(t,i[s],e.y,e.y+=a),t):ec(new un(a),i[s]));if(!(l>i.length)){if(o==0)return e.b=l,t?(t.set(i.subarray(s,l),e.y),e.y+=a,t):Mg(i,s,l);if(o==2){var c=i[s],h=c&3,u=c>>2&3,d=c>>4,f=0,g=0;h<2?u&1?d|=i[++s]<<4|(u&2&&i[++s]<<12):d=c>>3:(g=u,u<2?(d|=(i[++s]&63)<<4,f=i[s]>>6|i[++s]<<2):u==2?(d|=i[++s]<<4|(i[++s]&3)<<12,f=i[s]>>2|i[++s]<<6):(d|=i[++s]<<4|(i[++s]&63)<<12,f=i[s]>>6|i[++s]<<2|i[++s]<<10)),++s;var y=t?t.subarray(e.y,e.y+e.m):new un(e.m),p=y.length-d;if(h==0)y.set(i.subarray(s,s+=d),p);else if(h==1)ec(y,i[s++],p);else{var m=e.h;if(h==2){var x=yL(i,s);f+=s-(s=x[0]),e.h=m=x[1]}else m||wn(0);(g?TL:Ql)(i.subarray(s,s+=f),y.subarray(p),m)}var C=i[s++];if(C){C==255?C=(i[s++]|i[s++]<<8)+32512:C>127&&(C=C-128<<8|i[s++]);var M=i[s++];M&3&&wn(0);for(var R=[bL,wL,xL],T=2;T>-1;--T){var v=M>>(T<<1)+2&3;if(v==1){var E=new un([0,0,i[s++]]);R[T]={s:E.subarray(2,3),n:E.subarray(0,1),t:new nf(E.buffer,0,1),b:0}}else v==2?(n=tc(i,s,9-(T&1)),s=n[0],R[T]=n[1]):v==3&&(e.t||wn(0),R[T]=e.t[T])}var z=e.t=R,k=z[0],N=z[1],W=z[2],H=i[l-1];H||wn(0);var I=(l<<3)-8+so(H)-W.b,F=I>>3,q=0,V=(i[F]|i[F+1]<<8)>>(I&7)&(1<<W.b)-1;F=(I-=N.b)>>3;var le=(i[F]|i[F+1]<<8)>>(I&7)&(1<<N.b)-1;F=(I-=k.b)>>3;var Z=(i[F]|i[F+1]<<8)>>(I&7)&(1<<k.b)-1;for(++C;--C;){var Q=W.s[V],ie=W.n[V],de=k.s[Z],ue=k.n[Z],ee=N.s[le],me=N.n[le];F=(I-=ee)>>3;var ge=1<<ee,ve=ge+((i[F]|i[F+1]<<8|i[F+2]<<16|i[F+3]<<24)>>>(I&7)&ge-1);F=(I-=Eg[de])>>3;var _e=ML[de]+((i[F]|i[F+1]<<8|i[F+2]<<16)>>(I&7)&(1<<Eg[de])-1);F=(I-=Tg[Q])>>3;var Ge=SL[Q]+((i[F]|i[F+1]<<8|i[F+2]<<16)>>(I&7)&(1<<Tg[Q])-1);if(F=(I-=ie)>>3,V=W.t[V]+((i[F]|i[F+1]<<8)>>(I&7)&(1<<ie)-1),F=(I-=ue)>>3,Z=k.t[Z]+((i[F]|i[F+1]<<8)>>(I&7)&(1<<ue)-1),F=(I-=me)>>3,le=N.t[le]+((i[F]|i[F+1]<<8)>>(I&7)&(1<<me)-1),ve>3)e.o[2]=e.o[1],e.o[1]=e.o[0],e.o[0]=ve-=3;else{var Ze=ve-(Ge!=0);Ze?(ve=Ze==3?e.o[0]-1:e.o[Ze],Ze>1&&(e.o[2]=e.o[1]),e.o[1]=e.o[0],e.o[0]=ve):ve=e.o[0]}for(var T=0;T<Ge;++T)y[q+T]=y[p+T];q+=Ge,p+=Ge;var Ue=q-ve;if(Ue<0){var st=-Ue,ct=e.e+Ue;st>_e&&(st=_e);for(var T=0;T<st;++T)y[q+T]=e.w[ct+T];q+=st,_e-=st,Ue=0}for(var T=0;T<_e;++T)y[q+T]=y[Ue+T];q+=_e}if(q!=p)for(;p<y.length;)y[q++]=y[p++];else q=y.length;t?e.y+=q:y=Mg(y,0,q)}else if(t){if(e.y+=d,p)for(var T=0;T<d;++T)y[T]=y[p+T]}else p&&(y=Mg(y,p));return e.b=l,y}wn(2)}},AL=function(i,e){if(i.length==1)return i[0];for(var t=new un(e),n=0,s=0;n<i.length;++n){var r=i[n];t.set(r,s),s+=r.length}return t};function qb(i,e){for(var t=[],n=+!e,s=0,r=0;i.length;){var o=vL(i,n||e);if(typeof o=="object"){for(n?(e=null,o.w.length==o.u&&(t.push(e=o.w),r+=o.u)):(t.push(e),o.e=0);!o.l;){var a=EL(i,o,e);a||wn(5),e?o.e=o.y:(t.push(a),r+=a.length,mL(o.w,0,a.length),o.w.set(a,o.w.length-a.length))}s=o.b+o.c*4}else s=o;i=i.subarray(s)}return AL(t,r)}var Ag=[137,77,67,65,80,48,13,10],nc={header:1,footer:2,schema:3,channel:4,message:5,chunk:6,dataEnd:15},Ss=9,$b=64*1024*1024,rf=class{constructor(e,t=()=>!0){this.received=e;this.wanted=t}received;wanted;buffer=new Uint8Array(65536);begin=0;end=0;begun=!1;topics=new Map;ended=!1;push(e){if(!this.ended){if(this.append(e),!this.begun){if(this.end-this.begin<Ag.length)return;if(Ag.some((t,n)=>this.buffer[this.begin+n]!==t))throw new Error("not an MCAP file");this.begin+=Ag.length,this.begun=!0}for(;this.end-this.begin>=Ss;){let t=new DataView(this.buffer.buffer,this.begin,this.end-this.begin),n=Number(t.getBigUint64(1,!0));if(n>$b)throw new Error("the recording is corrupted: a record of impossible length");if(t.byteLength<Ss+n)break;let s=this.buffer.subarray(this.begin+Ss,this.begin+Ss+n);this.begin+=Ss+n;let r=t.getUint8(0);if(r===nc.dataEnd||r===nc.footer){this.ended=!0;break}this.record(r,s)}}}append(e){let t=this.end-this.begin;if(this.end+e.length>this.buffer.length){let n=Math.max(this.buffer.length,t+e.length),s=n>this.buffer.length?new Uint8Array(2*n):this.buffer;s.set(this.buffer.subarray(this.begin,this.end)),this.buffer=s,this.begin=0,this.end=t}this.buffer.set(e,this.end),this.end+=e.length}record(e,t){let n=new DataView(t.buffer,t.byteOffset,t.byteLength);if(e===nc.channel&&t.length>=8)this.topics.set(n.getUint16(0,!0),Yb(t,n,4).text);else if(e===nc.message&&t.length>=22){let s=this.topics.get(n.getUint16(0,!0)),r=Number(n.getBigUint64(6,!0))*1e-9;s!==void 0&&this.wanted(s,r)&&this.received({topic:s,time_s:r,data:t.subarray(22)})}else e===nc.chunk&&t.length>=32&&this.chunk(t,n)}chunk(e,t){let n=Number(t.getBigUint64(16,!0));if(n>$b)throw new Error("the recording is corrupted: a chunk of impossible length");let s=Yb(e,t,28),r=e.subarray(s.next+8),o=r;if(s.text==="zstd")o=qb(r,new Uint8Array(n));else if(s.text!=="")throw new Error(`chunks compressed with "${s.text}" cannot be read here`);let a=0;for(;o.length-a>=Ss;){let l=new DataView(o.buffer,o.byteOffset+a),c=Number(l.getBigUint64(1,!0));if(c>o.length-a-Ss)throw new Error("the recording is corrupted: a chunk ends too early");this.record(l.getUint8(0),o.subarray(a+Ss,a+Ss+c)),a+=Ss+c}}},CL=new TextDecoder;function Yb(i,e,t){let n=e.getUint32(t,!0);if(n>i.length-t-4)throw new Error("the recording is corrupted: a text ends too early");return{text:CL.decode(i.subarray(t+4,t+4+n)),next:t+4+n}}var of=class{constructor(e,t){this.capacity=e;this.interval_s=t}capacity;interval_s;items=[];wants(e){let t=this.items.at(-1);return t===void 0||e-t.time_s>=this.interval_s}add(e,t){if(this.wants(e)){if(this.items.length===this.capacity){for(let s=0;2*s<this.capacity;s++){let r=this.items[2*s];r!==void 0&&(this.items[s]=r)}this.items.length=Math.ceil(this.capacity/2);let n=(this.items.at(-1)?.time_s??0)-(this.items[0]?.time_s??0);if(this.interval_s=Math.max(2*this.interval_s,n/this.items.length),!this.wants(e))return}this.items.push({time_s:e,item:t})}}};var PL={"/course":[4,0],"/estimate":[2e4,.0199],"/slip":[8e3,.049],"/sample":[15e3,.0399],"/command":[15e3,.0399],"/state":[8e3,0],"/event":[2e3,0],"/link":[2e3,.19],"/loop":[2e3,.49]},Cg=class{topics=new Map;decoder=new TextDecoder;scanner;constructor(){for(let[e,[t,n]]of Object.entries(PL))this.topics.set(e,new of(t,n));this.scanner=new rf(({topic:e,time_s:t,data:n})=>{try{this.topics.get(e)?.add(t,JSON.parse(this.decoder.decode(n)))}catch{}},(e,t)=>this.topics.get(e)?.wants(t)===!0)}push(e){this.scanner.push(e)}frames(){let e=[];for(let[t,n]of this.topics)for(let{time_s:s,item:r}of n.items)e.push({time_s:s,topic:t,message:r});return e.sort((t,n)=>t.time_s-n.time_s)}};async function Kb(i,e,t){let n=await fetch(i,{signal:t});if(!n.ok||n.body===null)throw new Error(`${i}: ${n.status} ${n.statusText}`);let s=Number(n.headers.get("Content-Length")??NaN),r=n.body.getReader(),o=new Cg,a=0;for(;;){let{done:c,value:h}=await r.read();if(c)break;a+=h.length,o.push(h),s>0&&e(a/s)}let l=o.frames();if(!l.some(c=>c.topic==="/estimate"))throw new Error("the recording holds no poses");return l}var Pg=new Map;function af(i){let e=Pg.get(i)??fetch(`/api/history${i}`).then(t=>t.ok?t.json():[]);return Pg.set(i,e),setTimeout(()=>Pg.delete(i),1e3),e}var lf=class{press_;daemon;lastTook_ms=null;get unsent(){return this.press_!==void 0&&!this.press_.sent}press(e){this.press_={at_ms:e,sent:!1,received:!1}}sent(){this.press_!==void 0&&(this.press_.sent=!0)}answered(e,t){this.press_!==void 0&&(e?(this.press_=void 0,this.lastTook_ms=t,this.daemon!==void 0&&(this.daemon={...this.daemon,latched:!0,status:"acknowledged",acknowledged_ms:t})):this.press_.received=!0)}disconnected(){this.press_!==void 0&&(this.press_.sent=!1,this.press_.received=!1)}received(e){this.daemon=e,this.lastTook_ms=e.acknowledged_ms??this.lastTook_ms,this.press_?.received===!0&&(e.status==="acknowledged"||!e.latched)&&(this.press_=void 0)}view(e){let t=this.press_;if(t!==void 0){let s=e-t.at_ms;return s<200?{kind:"pending"}:{kind:"not_acknowledged",since_ms:s,waiting:!t.sent}}let n=this.daemon;return n?.latched!==!0?{kind:"ready"}:n.status==="acknowledged"||n.status==="none"?{kind:"stopped",took_ms:n.acknowledged_ms??this.lastTook_ms,by:n.by}:n.status==="pending"?{kind:"pending"}:{kind:"not_acknowledged",since_ms:200,waiting:!1}}};function Rg(i){return i instanceof HTMLElement&&i.matches("input:not([type=range]), select, textarea")}function Zb(i){window.addEventListener("keydown",e=>{if(e.key==="Escape"||e.code==="Space"&&!Rg(e.target)){e.preventDefault(),e.repeat||i.stop();return}if(!(e.ctrlKey||e.metaKey||e.altKey||Rg(e.target))){if(i.driveKey(e.code,!0)){e.preventDefault(),e.stopPropagation();return}e.key==="r"&&!e.repeat?i.start():e.key==="h"&&!e.repeat?i.hold():e.key==="p"&&!e.repeat?i.pause():e.key==="m"&&!e.repeat?i.drive():e.key==="c"?i.nextCamera():e.key>="1"&&e.key<="4"?i.camera(Number(e.key)-1):e.key==="?"?i.keys():e.key==="["?i.step(-1):e.key==="]"&&i.step(1)}},{capture:!0}),window.addEventListener("keyup",e=>{e.code==="Space"&&!Rg(e.target)&&e.preventDefault(),i.driveKey(e.code,!1)},{capture:!0})}function Jb(i){let e=i.map(()=>0),t=n=>{i.forEach((s,r)=>{n<(e[r]??0)||(e[r]=n+s.period_ms,s.run(n))}),requestAnimationFrame(t)};requestAnimationFrame(t)}var LL=["/state","/course","/path_history","/estimate","/slip","/link","/loop","/event","/parameter","/recording","/client"],IL=250,DL=100,NL=1e3/30-8,kL=100,OL=200,UL=60,Hn=new zl,Ts=Hn,ns,Ig,Ng="",Ms=new lf,cf={},sw=0,tn=new Xu(()=>{let i=new WebSocket(location.origin.replace(/^http/,"ws")+"/",by);return i.binaryType="arraybuffer",i},{serverInfo:i=>{cf=i.metadata},ready:()=>{Ms.unsent&&kg()},closed:i=>{sw=performance.now()+i,Ms.disconnected(),Es.lose("the connection to the daemon is lost")},status:(i,e)=>{i>0&&lo.say(e,performance.now())},parameters:()=>{}});function rw(){ro.forget(),ic.forget(),Ms.press(performance.now()),tn.ready?kg():tn.retryNow(),Og.show(Ms.view(performance.now()))}function kg(){Ms.sent(),tn.call("stop").then(i=>{let e=i,t=typeof e?.acknowledged_ms=="number"?e.acknowledged_ms:null;Ms.answered(e?.acknowledged===!0,t)},()=>{Ms.disconnected(),setTimeout(()=>{Ms.unsent&&tn.ready&&kg()},IL)})}async function FL(i,e){Ig?.abort();let t=Ig=new AbortController;Ng=e,oo.loading(e,0);try{let n=await Kb(i,s=>{oo.loading(e,s)},t.signal);ns=new tf(n,new zl(()=>0)),oo.open(e,ns),ao.look(ns.frames),ow(ns.store),ns.playing=!0}catch(n){if(t.signal.aborted)return;hf(),lo.say(n instanceof Error?n.message:String(n),performance.now())}}function hf(){Ig?.abort(),ns=void 0,Ng="",oo.close(),ao.look(void 0),ow(Hn)}function ow(i){Ts=i,document.body.classList.toggle("replaying",i!==Hn),uf.window_s=ns===void 0?UL:Math.min(Math.max(ns.duration_s,20),Im),As.reset(),Fg.reset(),Bg.reset()}function jb(i,e={}){tn.call(i,e).catch(t=>{lo.say(t instanceof Error?t.message:String(t),performance.now())})}function BL(){return ns===void 0?Number(cf.start_unix_ns??NaN)/1e9||void 0:ns.began_unix_s}function Ma(){return cf.commands!=="stop"}function zL(i){i&&(hf(),As.set("map")),ff.show(i),Ta.drawing(i)}function VL(i){i&&(hf(),ff.show(!1),As.set("map")),Ta.element.hidden=i,document.body.classList.toggle("drawing",i)}var Og=new Hd(rw),ro=new Zu(jb,i=>{jb("start",{from:i})}),Ug=new Gu(()=>navigator.getGamepads(),()=>performance.now()),Es=new zu((i,e)=>tn.call(i,e),Ug,()=>document.visibilityState==="visible"&&document.hasFocus(),i=>{i!==""&&lo.say(`Driving by hand: ${i}`,performance.now())}),ic=new od(Es,Ug),aw=new Gd,lo=new pd,As=new ef,Fg=new Wd,lw=new md,uf=new Od,Bg=new hd,cw=new $u(i=>{lo.say(i,performance.now())}),Qb=new cd(cw.elements),Dg=new Ud((i,e)=>{FL(i.url,e.run)},i=>tn.call(i.name,i.request)),oo=new Xd(hf),ew=new vd((i,e)=>{tn.setParameter(i,e)},(i,e)=>tn.call(i,e)),ao=new Vd(af),tw=new fd,nw=new rd(i=>tn.call("doctor",{part:i})),hw=i=>tn.call(i.name,i.request),df=new Bu(As,hw,()=>Hn.get("/course")?.robot,VL),Ta=new id(hw,zL,df),GL=A("div",{},Ta.element,df.element),ff=new yd(i=>As.world(i),()=>Hn.pose?.yaw_rad??0,i=>{ff.show(!1),Ta.placed(i)}),pf=new ad([{id:"events",title:"Events",element:Qb.element,show:()=>{Qb.show(Ts,BL())}},{id:"courses",title:"Courses",element:GL,show:()=>{Ta.show(Hn,tn.ready,Ma())}},{id:"runs",title:"Runs",element:Dg.element,show:()=>{Dg.show(tn.ready&&Ma(),Ng)}},{id:"parameters",title:"Parameters",element:ew.element,show:()=>{ew.show(Hn,tn.ready,Ma())}},{id:"signals",title:"Signals",element:ao.element,show:()=>{ao.show(Ts)}},{id:"link",title:"Link",element:tw.element,show:()=>{tw.show(Ts)}},{id:"doctor",title:"Doctor",element:nw.element,show:()=>{nw.show(Hn,tn.ready,Ma())}},{id:"keys",title:"Keys",element:By(),show:()=>{}}]),uw=new ud,HL=A("header",{class:"bar"},uw.element,aw.element,ro.element,Og.element);uf.element.append(Bg.element);ro.element.append(ic.button);As.element.append(df.stage.element,ff.element,ic.element,lo.element,oo.element,Fg.element);document.body.append(HL,A("main",{},As.element,lw.element,uf.element,pf.element));for(let i of LL)tn.subscribe(i,e=>{Hn.receive(i,e),ao.receive(i,e),cw.alerts.received(i,e,Hn),i==="/state"?(Ms.received(e.stop),Es.received(e)):i==="/recording"?Dg.changed():i==="/path_history"&&tn.unsubscribe(i)});Promise.all([af("/estimate"),af("/slip")]).then(([i,e])=>{Hn.before(i,e)},()=>{});var WL=["/sample","/command"],Lg=new Set;function XL(){for(let i of WL){let e=pf.selected==="signals"||ao.needs(i);e!==Lg.has(i)&&(e?tn.subscribe(i,t=>{ao.receive(i,t)}):tn.unsubscribe(i),e?Lg.add(i):Lg.delete(i))}}Zb({stop:rw,start:()=>{ro.pressStart()},hold:()=>{ro.pressHold()},pause:()=>{ro.pressPause()},drive:()=>{ic.press()},driveKey:(i,e)=>qL(i,e),camera:i=>{As.set(Qd[i]??"free")},nextCamera:()=>{As.next()},keys:()=>{pf.select("keys")},step:i=>{oo.step(i)}});function qL(i,e){if(!Es.drives&&e)return!1;let t=Ug.key(i,e)&&Es.drives;return t&&Es.tick(),t}setInterval(()=>{Es.tick()},40);for(let i of["blur","pagehide"])window.addEventListener(i,()=>{Es.leave()});document.addEventListener("visibilitychange",()=>{document.visibilityState!=="visible"&&Es.leave()});window.addEventListener("gamepaddisconnected",()=>{Es.tick()});var iw=performance.now();Jb([{period_ms:0,run:()=>{Og.show(Ms.view(performance.now()))}},{period_ms:NL,run:$L},{period_ms:DL,run:()=>{lw.show(Ts),Fg.show(Ts),oo.show()}},{period_ms:kL,run:()=>{uf.show(Ts)}},{period_ms:OL,run:YL}]);function $L(i){let e=Math.min((i-iw)/1e3,.5);iw=i,ns?.tick(e),As.draw(Ts,e),df.tick(i,Ta.changeable)}function YL(i){aw.show(Hn,tn.ready),ro.show(Hn,tn.ready,Ma()),ic.show(Hn,tn.ready,Ma()),lo.show(Hn,tn.ready,(sw-i)/1e3,i,Ts!==Hn),Bg.show(Ts),pf.show(),XL(),uw.show(Hn,cf)}
