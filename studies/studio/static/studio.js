"use strict";(()=>{var ng="acoustic-fem-studio-secret",sc="";function ig(){let i=document.querySelector("meta[name=secret]");if(i){sc=i.content,i.remove();try{localStorage.setItem(ng,sc)}catch{}}location.search&&history.replaceState(null,"",`/${location.hash}`)}function xd(){try{return localStorage.getItem(ng)??sc}catch{return sc}}function yo(){return{"x-studio-secret":xd()}}var xr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},_r={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},qg=0,tf=1,$g=2;var xl=1,Yg=2,ta=3,xs=0,ri=1,fi=2,Yr=0,na=1,nf=2,sf=3,rf=4,Kg=5;var Kr=100,jg=101,Zg=102,Jg=103,Qg=104,e0=200,t0=201,n0=202,i0=203,of=204,af=205,s0=206,r0=207,o0=208,a0=209,l0=210,c0=211,h0=212,u0=213,d0=214,Lc=0,Nc=1,Dc=2,Uo=3,Oc=4,Uc=5,Fc=6,kc=7,lf=0,f0=1,p0=2,_s=0,cf=1,hf=2,uf=3,df=4,ff=5,pf=6,mf=7,Vd="attached",m0="detached",gf=300,jr=301,ia=302,nh=303,ih=304,fr=1e3,Oi=1001,Fo=1002,cn=1003,sh=1004;var Zr=1005;var Sn=1006,sa=1007;var Fi=1008;var pi=1009,xf=1010,_f=1011,ra=1012,rh=1013,ji=1014,Mi=1015,Zi=1016,oh=1017,ah=1018,Jr=1020,vf=35902,yf=35899,bf=1021,Sf=1022,ki=1023,Fs=1026,$s=1027,lh=1028,ch=1029,vr=1030,hh=1031;var uh=1033,_l=33776,vl=33777,yl=33778,bl=33779,dh=35840,fh=35841,ph=35842,mh=35843,gh=36196,xh=37492,_h=37496,vh=37488,yh=37489,Sl=37490,bh=37491,Sh=37808,Mh=37809,wh=37810,Th=37811,Eh=37812,Ah=37813,Rh=37814,Ch=37815,Ph=37816,Ih=37817,Lh=37818,Nh=37819,Dh=37820,Oh=37821,Uh=36492,Fh=36494,kh=36495,Bh=36283,zh=36284,Ml=36285,Hh=36286;var zr=2300,Hr=2301,Pc=2302,Gd=2303,Wd=2400,Xd=2401,qd=2402,g0=2500;var Mf=0,wl=1,oa=2,x0=3200;var Vh=0,_0=1,Ys="",yn="srgb",ii="srgb-linear",Xa="linear",Ct="srgb";var Ic=7680;var v0=519,y0=512,b0=513,S0=514,wf=515,M0=516,w0=517,Tf=518,Ef=519,Af=35044;var Rf="300 es",Ui=2e3,ko=2001;function dy(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function fy(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Bo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function T0(){let i=Bo("canvas");return i.style.display="block",i}var sg={},zo=null;function qa(...i){let e="THREE."+i.shift();zo?zo("log",e,...i):console.log(e,...i)}function E0(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function qe(...i){i=E0(i);let e="THREE."+i.shift();if(zo)zo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function nt(...i){i=E0(i);let e="THREE."+i.shift();if(zo)zo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Br(...i){let e=i.join(" ");e in sg||(sg[e]=!0,qe(...i))}function A0(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var R0={[Lc]:Lc,[Dc]:Fc,[Oc]:Oc,[Uo]:Uc,[Nc]:Nc,[Fc]:Dc,[kc]:kc,[Uc]:Uo},Ki=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},qn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],rg=1234567,Ga=Math.PI/180,Vr=180/Math.PI;function vs(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(qn[i&255]+qn[i>>8&255]+qn[i>>16&255]+qn[i>>24&255]+"-"+qn[e&255]+qn[e>>8&255]+"-"+qn[e>>16&15|64]+qn[e>>24&255]+"-"+qn[t&63|128]+qn[t>>8&255]+"-"+qn[t>>16&255]+qn[t>>24&255]+qn[n&255]+qn[n>>8&255]+qn[n>>16&255]+qn[n>>24&255]).toLowerCase()}function gt(i,e,t){return Math.max(e,Math.min(t,i))}function Cf(i,e){return(i%e+e)%e}function py(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function my(i,e,t){return i!==e?(t-i)/(e-i):0}function Wa(i,e,t){return(1-t)*i+t*e}function gy(i,e,t,n){return Wa(i,e,1-Math.exp(-t*n))}function xy(i,e=1){return e-Math.abs(Cf(i,e*2)-e)}function _y(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function vy(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function yy(i,e){return i+Math.floor(Math.random()*(e-i+1))}function by(i,e){return i+Math.random()*(e-i)}function Sy(i){return i*(.5-Math.random())}function My(i){i!==void 0&&(rg=i);let e=rg+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function wy(i){return i*Ga}function Ty(i){return i*Vr}function Ey(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Ay(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Pf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Ry(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),c=o(t/2),l=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),p=o((n-e)/2);switch(s){case"XYX":i.set(a*h,c*u,c*d,a*l);break;case"YZY":i.set(c*d,a*h,c*u,a*l);break;case"ZXZ":i.set(c*u,c*d,a*h,a*l);break;case"XZX":i.set(a*h,c*p,c*f,a*l);break;case"YXY":i.set(c*f,a*h,c*p,a*l);break;case"ZYZ":i.set(c*p,c*f,a*h,a*l);break;default:qe("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Gh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function If(i,e){if(e.constructor===Float32Array)return i;let t=Gh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Lf(i,e){if(e.constructor===Float32Array)return i;let t=Gh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var aa={DEG2RAD:Ga,RAD2DEG:Vr,generateUUID:vs,clamp:gt,euclideanModulo:Cf,mapLinear:py,inverseLerp:my,lerp:Wa,damp:gy,pingpong:xy,smoothstep:_y,smootherstep:vy,randInt:yy,randFloat:by,randFloatSpread:Sy,seededRandom:My,degToRad:wy,radToDeg:Ty,isPowerOfTwo:Ey,ceilPowerOfTwo:Ay,floorPowerOfTwo:Pf,setQuaternionFromProperEuler:Ry,normalize:Lf,denormalize:If},je=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(gt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(gt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Fn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let c=n[s+0],l=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],v=r[o+3];if(u!==v||c!==d||l!==f||h!==p){let g=c*d+l*f+h*p+u*v;g<0&&(d=-d,f=-f,p=-p,v=-v,g=-g);let m=1-a;if(g<.9995){let y=Math.acos(g),M=Math.sin(y);m=Math.sin(m*y)/M,a=Math.sin(a*y)/M,c=c*m+d*a,l=l*m+f*a,h=h*m+p*a,u=u*m+v*a}else{c=c*m+d*a,l=l*m+f*a,h=h*m+p*a,u=u*m+v*a;let y=1/Math.sqrt(c*c+l*l+h*h+u*u);c*=y,l*=y,h*=y,u*=y}}e[t]=c,e[t+1]=l,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],c=n[s+1],l=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+h*u+c*f-l*d,e[t+1]=c*p+h*d+l*u-a*f,e[t+2]=l*p+h*f+a*d-c*u,e[t+3]=h*p-a*u-c*d-l*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,c=Math.sin,l=a(n/2),h=a(s/2),u=a(r/2),d=c(n/2),f=c(s/2),p=c(r/2);switch(o){case"XYZ":this._x=d*h*u+l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u+d*f*p;break;case"YZX":this._x=d*h*u+l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u-d*f*p;break;case"XZY":this._x=d*h*u-l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u+d*f*p;break;default:qe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],c=t[9],l=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(gt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,c=t._y,l=t._z,h=t._w;return this._x=n*h+o*a+s*l-r*c,this._y=s*h+o*c+r*a-n*l,this._z=r*h+o*l+n*c-s*a,this._w=o*h-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let c=1-t;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,t=Math.sin(t*l)/h,this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this._onChangeCallback()}else this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},V=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(og.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(og.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,c=e.w,l=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+c*l+o*u-a*h,this.y=n+c*h+a*l-r*u,this.z=s+c*u+r*h-o*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(gt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,c=t.z;return this.x=s*c-r*a,this.y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return _d.copy(this).projectOnVector(e),this.sub(_d)}reflect(e){return this.sub(_d.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(gt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},_d=new V,og=new Fn,st=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l)}set(e,t,n,s,r,o,a,c,l){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=c,h[6]=n,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],v=s[0],g=s[3],m=s[6],y=s[1],M=s[4],b=s[7],C=s[2],A=s[5],x=s[8];return r[0]=o*v+a*y+c*C,r[3]=o*g+a*M+c*A,r[6]=o*m+a*b+c*x,r[1]=l*v+h*y+u*C,r[4]=l*g+h*M+u*A,r[7]=l*m+h*b+u*x,r[2]=d*v+f*y+p*C,r[5]=d*g+f*M+p*A,r[8]=d*m+f*b+p*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8];return t*o*h-t*a*l-n*r*h+n*a*c+s*r*l-s*o*c}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8],u=h*o-a*l,d=a*c-h*r,f=l*r-o*c,p=t*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return e[0]=u*v,e[1]=(s*l-h*n)*v,e[2]=(a*n-s*o)*v,e[3]=d*v,e[4]=(h*t-s*c)*v,e[5]=(s*r-a*t)*v,e[6]=f*v,e[7]=(n*c-l*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+e,-s*l,s*c,-s*(-l*o+c*a)+a+t,0,0,1),this}scale(e,t){return Br("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(vd.makeScale(e,t)),this}rotate(e){return Br("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(vd.makeRotation(-e)),this}translate(e,t){return Br("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(vd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},vd=new st,ag=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),lg=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Cy(){let i={enabled:!0,workingColorSpace:ii,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ct&&(s.r=Us(s.r),s.g=Us(s.g),s.b=Us(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ct&&(s.r=Oo(s.r),s.g=Oo(s.g),s.b=Oo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ys?Xa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[ii]:{primaries:e,whitePoint:n,transfer:Xa,toXYZ:ag,fromXYZ:lg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:yn},outputColorSpaceConfig:{drawingBufferColorSpace:yn}},[yn]:{primaries:e,whitePoint:n,transfer:Ct,toXYZ:ag,fromXYZ:lg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:yn}}}),i}var mt=Cy();function Us(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Oo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var bo,Bc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{bo===void 0&&(bo=Bo("canvas")),bo.width=e.width,bo.height=e.height;let s=bo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=bo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Bo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Us(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Us(t[n]/255)*255):t[n]=Us(t[n]);return{data:t,width:e.width,height:e.height}}else return qe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Py=0,Ho=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Py++}),this.uuid=vs(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(yd(s[o].image)):r.push(yd(s[o]))}else r=yd(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function yd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Bc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(qe("Texture: Unable to serialize Texture."),{})}var Iy=0,bd=new V,kn=class i extends Ki{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Oi,s=Oi,r=Sn,o=Fi,a=ki,c=pi,l=i.DEFAULT_ANISOTROPY,h=Ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Iy++}),this.uuid=vs(),this.name="",this.source=new Ho(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new je(0,0),this.repeat=new je(1,1),this.center=new je(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(bd).x}get height(){return this.source.getSize(bd).y}get depth(){return this.source.getSize(bd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){qe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){qe(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==gf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case fr:e.x=e.x-Math.floor(e.x);break;case Oi:e.x=e.x<0?0:1;break;case Fo:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case fr:e.y=e.y-Math.floor(e.y);break;case Oi:e.y=e.y<0?0:1;break;case Fo:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};kn.DEFAULT_IMAGE=null;kn.DEFAULT_MAPPING=gf;kn.DEFAULT_ANISOTROPY=1;var Dt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,c=e.elements,l=c[0],h=c[4],u=c[8],d=c[1],f=c[5],p=c[9],v=c[2],g=c[6],m=c[10];if(Math.abs(h-d)<.01&&Math.abs(u-v)<.01&&Math.abs(p-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+v)<.1&&Math.abs(p+g)<.1&&Math.abs(l+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(l+1)/2,b=(f+1)/2,C=(m+1)/2,A=(h+d)/4,x=(u+v)/4,E=(p+g)/4;return M>b&&M>C?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=A/n,r=x/n):b>C?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=A/s,r=E/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=x/r,s=E/r),this.set(n,s,r,t),this}let y=Math.sqrt((g-p)*(g-p)+(u-v)*(u-v)+(d-h)*(d-h));return Math.abs(y)<.001&&(y=1),this.x=(g-p)/y,this.y=(u-v)/y,this.z=(d-h)/y,this.w=Math.acos((l+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this.w=gt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this.w=gt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(gt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},zc=class extends Ki{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Sn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Dt(0,0,e,t),this.scissorTest=!1,this.viewport=new Dt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new kn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Sn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Ho(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Si=class extends zc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},$a=class extends kn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=cn,this.minFilter=cn,this.wrapR=Oi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Hc=class extends kn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=cn,this.minFilter=cn,this.wrapR=Oi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var ct=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,c,l,h,u,d,f,p,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l,h,u,d,f,p,v,g)}set(e,t,n,s,r,o,a,c,l,h,u,d,f,p,v,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=c,m[2]=l,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=p,m[11]=v,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/So.setFromMatrixColumn(e,0).length(),r=1/So.setFromMatrixColumn(e,1).length(),o=1/So.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,p=a*h,v=a*u;t[0]=c*h,t[4]=-c*u,t[8]=l,t[1]=f+p*l,t[5]=d-v*l,t[9]=-a*c,t[2]=v-d*l,t[6]=p+f*l,t[10]=o*c}else if(e.order==="YXZ"){let d=c*h,f=c*u,p=l*h,v=l*u;t[0]=d+v*a,t[4]=p*a-f,t[8]=o*l,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-p,t[6]=v+d*a,t[10]=o*c}else if(e.order==="ZXY"){let d=c*h,f=c*u,p=l*h,v=l*u;t[0]=d-v*a,t[4]=-o*u,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*h,t[9]=v-d*a,t[2]=-o*l,t[6]=a,t[10]=o*c}else if(e.order==="ZYX"){let d=o*h,f=o*u,p=a*h,v=a*u;t[0]=c*h,t[4]=p*l-f,t[8]=d*l+v,t[1]=c*u,t[5]=v*l+d,t[9]=f*l-p,t[2]=-l,t[6]=a*c,t[10]=o*c}else if(e.order==="YZX"){let d=o*c,f=o*l,p=a*c,v=a*l;t[0]=c*h,t[4]=v-d*u,t[8]=p*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-l*h,t[6]=f*u+p,t[10]=d-v*u}else if(e.order==="XZY"){let d=o*c,f=o*l,p=a*c,v=a*l;t[0]=c*h,t[4]=-u,t[8]=l*h,t[1]=d*u+v,t[5]=o*h,t[9]=f*u-p,t[2]=p*u-f,t[6]=a*h,t[10]=v*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Ly,e,Ny)}lookAt(e,t,n){let s=this.elements;return yi.subVectors(e,t),yi.lengthSq()===0&&(yi.z=1),yi.normalize(),or.crossVectors(n,yi),or.lengthSq()===0&&(Math.abs(n.z)===1?yi.x+=1e-4:yi.z+=1e-4,yi.normalize(),or.crossVectors(n,yi)),or.normalize(),rc.crossVectors(yi,or),s[0]=or.x,s[4]=rc.x,s[8]=yi.x,s[1]=or.y,s[5]=rc.y,s[9]=yi.y,s[2]=or.z,s[6]=rc.z,s[10]=yi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],v=n[6],g=n[10],m=n[14],y=n[3],M=n[7],b=n[11],C=n[15],A=s[0],x=s[4],E=s[8],k=s[12],D=s[1],L=s[5],W=s[9],X=s[13],O=s[2],H=s[6],Y=s[10],B=s[14],ce=s[3],Z=s[7],ee=s[11],se=s[15];return r[0]=o*A+a*D+c*O+l*ce,r[4]=o*x+a*L+c*H+l*Z,r[8]=o*E+a*W+c*Y+l*ee,r[12]=o*k+a*X+c*B+l*se,r[1]=h*A+u*D+d*O+f*ce,r[5]=h*x+u*L+d*H+f*Z,r[9]=h*E+u*W+d*Y+f*ee,r[13]=h*k+u*X+d*B+f*se,r[2]=p*A+v*D+g*O+m*ce,r[6]=p*x+v*L+g*H+m*Z,r[10]=p*E+v*W+g*Y+m*ee,r[14]=p*k+v*X+g*B+m*se,r[3]=y*A+M*D+b*O+C*ce,r[7]=y*x+M*L+b*H+C*Z,r[11]=y*E+M*W+b*Y+C*ee,r[15]=y*k+M*X+b*B+C*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],c=e[9],l=e[13],h=e[2],u=e[6],d=e[10],f=e[14],p=e[3],v=e[7],g=e[11],m=e[15],y=c*f-l*d,M=a*f-l*u,b=a*d-c*u,C=o*f-l*h,A=o*d-c*h,x=o*u-a*h;return t*(v*y-g*M+m*b)-n*(p*y-g*C+m*A)+s*(p*M-v*C+m*x)-r*(p*b-v*A+g*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],c=e[2],l=e[6],h=e[10];return t*(o*h-a*l)-n*(r*h-a*c)+s*(r*l-o*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],h=e[8],u=e[9],d=e[10],f=e[11],p=e[12],v=e[13],g=e[14],m=e[15],y=t*a-n*o,M=t*c-s*o,b=t*l-r*o,C=n*c-s*a,A=n*l-r*a,x=s*l-r*c,E=h*v-u*p,k=h*g-d*p,D=h*m-f*p,L=u*g-d*v,W=u*m-f*v,X=d*m-f*g,O=y*X-M*W+b*L+C*D-A*k+x*E;if(O===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/O;return e[0]=(a*X-c*W+l*L)*H,e[1]=(s*W-n*X-r*L)*H,e[2]=(v*x-g*A+m*C)*H,e[3]=(d*A-u*x-f*C)*H,e[4]=(c*D-o*X-l*k)*H,e[5]=(t*X-s*D+r*k)*H,e[6]=(g*b-p*x-m*M)*H,e[7]=(h*x-d*b+f*M)*H,e[8]=(o*W-a*D+l*E)*H,e[9]=(n*D-t*W-r*E)*H,e[10]=(p*A-v*b+m*y)*H,e[11]=(u*b-h*A-f*y)*H,e[12]=(a*k-o*L-c*E)*H,e[13]=(t*L-n*k+s*E)*H,e[14]=(v*M-p*C-g*y)*H,e[15]=(h*C-u*M+d*y)*H,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,c=e.z,l=r*o,h=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,h*a+n,h*c-s*o,0,l*c-s*a,h*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,c=t._w,l=r+r,h=o+o,u=a+a,d=r*l,f=r*h,p=r*u,v=o*h,g=o*u,m=a*u,y=c*l,M=c*h,b=c*u,C=n.x,A=n.y,x=n.z;return s[0]=(1-(v+m))*C,s[1]=(f+b)*C,s[2]=(p-M)*C,s[3]=0,s[4]=(f-b)*A,s[5]=(1-(d+m))*A,s[6]=(g+y)*A,s[7]=0,s[8]=(p+M)*x,s[9]=(g-y)*x,s[10]=(1-(d+v))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=So.set(s[0],s[1],s[2]).length(),a=So.set(s[4],s[5],s[6]).length(),c=So.set(s[8],s[9],s[10]).length();r<0&&(o=-o),qi.copy(this);let l=1/o,h=1/a,u=1/c;return qi.elements[0]*=l,qi.elements[1]*=l,qi.elements[2]*=l,qi.elements[4]*=h,qi.elements[5]*=h,qi.elements[6]*=h,qi.elements[8]*=u,qi.elements[9]*=u,qi.elements[10]*=u,t.setFromRotationMatrix(qi),n.x=o,n.y=a,n.z=c,this}makePerspective(e,t,n,s,r,o,a=Ui,c=!1){let l=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),p,v;if(c)p=r/(o-r),v=o*r/(o-r);else if(a===Ui)p=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===ko)p=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=v,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ui,c=!1){let l=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),p,v;if(c)p=1/(o-r),v=o/(o-r);else if(a===Ui)p=-2/(o-r),v=-(o+r)/(o-r);else if(a===ko)p=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=u,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=p,l[14]=v,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},So=new V,qi=new ct,Ly=new V(0,0,0),Ny=new V(1,1,1),or=new V,rc=new V,yi=new V,cg=new ct,hg=new Fn,ks=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(gt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-gt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(gt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-gt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(gt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-gt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:qe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return cg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(cg,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return hg.setFromEuler(this),this.setFromQuaternion(hg,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ks.DEFAULT_ORDER="XYZ";var Vo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Dy=0,ug=new V,Mo=new Fn,Ps=new ct,oc=new V,Da=new V,Oy=new V,Uy=new Fn,dg=new V(1,0,0),fg=new V(0,1,0),pg=new V(0,0,1),mg={type:"added"},Fy={type:"removed"},wo={type:"childadded",child:null},Sd={type:"childremoved",child:null},jt=class i extends Ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Dy++}),this.uuid=vs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new V,t=new ks,n=new Fn,s=new V(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ct},normalMatrix:{value:new st}}),this.matrix=new ct,this.matrixWorld=new ct,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Vo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Mo.setFromAxisAngle(e,t),this.quaternion.multiply(Mo),this}rotateOnWorldAxis(e,t){return Mo.setFromAxisAngle(e,t),this.quaternion.premultiply(Mo),this}rotateX(e){return this.rotateOnAxis(dg,e)}rotateY(e){return this.rotateOnAxis(fg,e)}rotateZ(e){return this.rotateOnAxis(pg,e)}translateOnAxis(e,t){return ug.copy(e).applyQuaternion(this.quaternion),this.position.add(ug.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(dg,e)}translateY(e){return this.translateOnAxis(fg,e)}translateZ(e){return this.translateOnAxis(pg,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ps.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?oc.copy(e):oc.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Da.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ps.lookAt(Da,oc,this.up):Ps.lookAt(oc,Da,this.up),this.quaternion.setFromRotationMatrix(Ps),s&&(Ps.extractRotation(s.matrixWorld),Mo.setFromRotationMatrix(Ps),this.quaternion.premultiply(Mo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(mg),wo.child=e,this.dispatchEvent(wo),wo.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Fy),Sd.child=e,this.dispatchEvent(Sd),Sd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ps.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ps.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ps),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(mg),wo.child=e,this.dispatchEvent(wo),wo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Da,e,Oy),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Da,Uy,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let u=c[l];r(e.shapes,u)}else r(e.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(e.materials,this.material[c]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(e.animations,c))}}if(t){let a=o(e.geometries),c=o(e.materials),l=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};jt.DEFAULT_UP=new V(0,1,0);jt.DEFAULT_MATRIX_AUTO_UPDATE=!0;jt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ni=class extends jt{constructor(){super(),this.isGroup=!0,this.type="Group"}},ky={type:"move"},Go=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ni,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ni,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ni,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,n),m=this._getHandJoint(l,v);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let h=l.joints["index-finger-tip"],u=l.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;l.inputState.pinching&&d>f+p?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&d<=f-p&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ky)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new ni;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},C0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ar={h:0,s:0,l:0},ac={h:0,s:0,l:0};function Md(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Ke=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=yn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,mt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=mt.workingColorSpace){return this.r=e,this.g=t,this.b=n,mt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=mt.workingColorSpace){if(e=Cf(e,1),t=gt(t,0,1),n=gt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Md(o,r,e+1/3),this.g=Md(o,r,e),this.b=Md(o,r,e-1/3)}return mt.colorSpaceToWorking(this,s),this}setStyle(e,t=yn){function n(r){r!==void 0&&parseFloat(r)<1&&qe("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:qe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);qe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=yn){let n=C0[e.toLowerCase()];return n!==void 0?this.setHex(n,t):qe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Us(e.r),this.g=Us(e.g),this.b=Us(e.b),this}copyLinearToSRGB(e){return this.r=Oo(e.r),this.g=Oo(e.g),this.b=Oo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=yn){return mt.workingToColorSpace($n.copy(this),e),Math.round(gt($n.r*255,0,255))*65536+Math.round(gt($n.g*255,0,255))*256+Math.round(gt($n.b*255,0,255))}getHexString(e=yn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=mt.workingColorSpace){mt.workingToColorSpace($n.copy(this),t);let n=$n.r,s=$n.g,r=$n.b,o=Math.max(n,s,r),a=Math.min(n,s,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let u=o-a;switch(l=h<=.5?u/(o+a):u/(2-o-a),o){case n:c=(s-r)/u+(s<r?6:0);break;case s:c=(r-n)/u+2;break;case r:c=(n-s)/u+4;break}c/=6}return e.h=c,e.s=l,e.l=h,e}getRGB(e,t=mt.workingColorSpace){return mt.workingToColorSpace($n.copy(this),t),e.r=$n.r,e.g=$n.g,e.b=$n.b,e}getStyle(e=yn){mt.workingToColorSpace($n.copy(this),e);let t=$n.r,n=$n.g,s=$n.b;return e!==yn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(ar),this.setHSL(ar.h+e,ar.s+t,ar.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(ar),e.getHSL(ac);let n=Wa(ar.h,ac.h,t),s=Wa(ar.s,ac.s,t),r=Wa(ar.l,ac.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},$n=new Ke;Ke.NAMES=C0;var Ya=class extends jt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ks,this.environmentIntensity=1,this.environmentRotation=new ks,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},$i=new V,Is=new V,wd=new V,Ls=new V,To=new V,Eo=new V,gg=new V,Td=new V,Ed=new V,Ad=new V,Rd=new Dt,Cd=new Dt,Pd=new Dt,dr=class i{constructor(e=new V,t=new V,n=new V){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),$i.subVectors(e,t),s.cross($i);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){$i.subVectors(s,t),Is.subVectors(n,t),wd.subVectors(e,t);let o=$i.dot($i),a=$i.dot(Is),c=$i.dot(wd),l=Is.dot(Is),h=Is.dot(wd),u=o*l-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(l*c-a*h)*d,p=(o*h-a*c)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Ls)===null?!1:Ls.x>=0&&Ls.y>=0&&Ls.x+Ls.y<=1}static getInterpolation(e,t,n,s,r,o,a,c){return this.getBarycoord(e,t,n,s,Ls)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,Ls.x),c.addScaledVector(o,Ls.y),c.addScaledVector(a,Ls.z),c)}static getInterpolatedAttribute(e,t,n,s,r,o){return Rd.setScalar(0),Cd.setScalar(0),Pd.setScalar(0),Rd.fromBufferAttribute(e,t),Cd.fromBufferAttribute(e,n),Pd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Rd,r.x),o.addScaledVector(Cd,r.y),o.addScaledVector(Pd,r.z),o}static isFrontFacing(e,t,n,s){return $i.subVectors(n,t),Is.subVectors(e,t),$i.cross(Is).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return $i.subVectors(this.c,this.b),Is.subVectors(this.a,this.b),$i.cross(Is).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;To.subVectors(s,n),Eo.subVectors(r,n),Td.subVectors(e,n);let c=To.dot(Td),l=Eo.dot(Td);if(c<=0&&l<=0)return t.copy(n);Ed.subVectors(e,s);let h=To.dot(Ed),u=Eo.dot(Ed);if(h>=0&&u<=h)return t.copy(s);let d=c*u-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),t.copy(n).addScaledVector(To,o);Ad.subVectors(e,r);let f=To.dot(Ad),p=Eo.dot(Ad);if(p>=0&&f<=p)return t.copy(r);let v=f*l-c*p;if(v<=0&&l>=0&&p<=0)return a=l/(l-p),t.copy(n).addScaledVector(Eo,a);let g=h*p-f*u;if(g<=0&&u-h>=0&&f-p>=0)return gg.subVectors(r,s),a=(u-h)/(u-h+(f-p)),t.copy(s).addScaledVector(gg,a);let m=1/(g+v+d);return o=v*m,a=d*m,t.copy(n).addScaledVector(To,o).addScaledVector(Eo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Hn=class{constructor(e=new V(1/0,1/0,1/0),t=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Yi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Yi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Yi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Yi):Yi.fromBufferAttribute(r,o),Yi.applyMatrix4(e.matrixWorld),this.expandByPoint(Yi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),lc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),lc.copy(n.boundingBox)),lc.applyMatrix4(e.matrixWorld),this.union(lc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Yi),Yi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Oa),cc.subVectors(this.max,Oa),Ao.subVectors(e.a,Oa),Ro.subVectors(e.b,Oa),Co.subVectors(e.c,Oa),lr.subVectors(Ro,Ao),cr.subVectors(Co,Ro),Or.subVectors(Ao,Co);let t=[0,-lr.z,lr.y,0,-cr.z,cr.y,0,-Or.z,Or.y,lr.z,0,-lr.x,cr.z,0,-cr.x,Or.z,0,-Or.x,-lr.y,lr.x,0,-cr.y,cr.x,0,-Or.y,Or.x,0];return!Id(t,Ao,Ro,Co,cc)||(t=[1,0,0,0,1,0,0,0,1],!Id(t,Ao,Ro,Co,cc))?!1:(hc.crossVectors(lr,cr),t=[hc.x,hc.y,hc.z],Id(t,Ao,Ro,Co,cc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Yi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Yi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ns[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ns[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ns[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ns[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ns[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ns[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ns[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ns[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ns),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ns=[new V,new V,new V,new V,new V,new V,new V,new V],Yi=new V,lc=new Hn,Ao=new V,Ro=new V,Co=new V,lr=new V,cr=new V,Or=new V,Oa=new V,cc=new V,hc=new V,Ur=new V;function Id(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Ur.fromArray(i,r);let a=s.x*Math.abs(Ur.x)+s.y*Math.abs(Ur.y)+s.z*Math.abs(Ur.z),c=e.dot(Ur),l=t.dot(Ur),h=n.dot(Ur);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var gn=new V,uc=new je,By=0,ln=class extends Ki{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:By++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Af,this.updateRanges=[],this.gpuType=Mi,this.version=0,this._normalizationScale=e!==void 0?Gh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)uc.fromBufferAttribute(this,t),uc.applyMatrix3(e),this.setXY(t,uc.x,uc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix3(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix4(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.applyNormalMatrix(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.transformDirection(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):If(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Lf(e,this.array)}};var Ka=class extends ln{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var ja=class extends ln{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Un=class extends ln{constructor(e,t,n){super(new Float32Array(e),t,n)}},zy=new Hn,Ua=new V,Ld=new V,ci=class{constructor(e=new V,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):zy.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ua.subVectors(e,this.center);let t=Ua.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Ua,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ld.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ua.copy(e.center).add(Ld)),this.expandByPoint(Ua.copy(e.center).sub(Ld))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Hy=0,Di=new ct,Nd=new jt,Po=new V,bi=new Hn,Fa=new Hn,On=new V,Vn=class i extends Ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Hy++}),this.uuid=vs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(dy(e)?ja:Ka)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new st().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Di.makeRotationFromQuaternion(e),this.applyMatrix4(Di),this}rotateX(e){return Di.makeRotationX(e),this.applyMatrix4(Di),this}rotateY(e){return Di.makeRotationY(e),this.applyMatrix4(Di),this}rotateZ(e){return Di.makeRotationZ(e),this.applyMatrix4(Di),this}translate(e,t,n){return Di.makeTranslation(e,t,n),this.applyMatrix4(Di),this}scale(e,t,n){return Di.makeScale(e,t,n),this.applyMatrix4(Di),this}lookAt(e){return Nd.lookAt(e),Nd.updateMatrix(),this.applyMatrix4(Nd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Po).negate(),this.translate(Po.x,Po.y,Po.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Un(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&qe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Hn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];bi.setFromBufferAttribute(r),this.morphTargetsRelative?(On.addVectors(this.boundingBox.min,bi.min),this.boundingBox.expandByPoint(On),On.addVectors(this.boundingBox.max,bi.max),this.boundingBox.expandByPoint(On)):(this.boundingBox.expandByPoint(bi.min),this.boundingBox.expandByPoint(bi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ci);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(e){let n=this.boundingSphere.center;if(bi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Fa.setFromBufferAttribute(a),this.morphTargetsRelative?(On.addVectors(bi.min,Fa.min),bi.expandByPoint(On),On.addVectors(bi.max,Fa.max),bi.expandByPoint(On)):(bi.expandByPoint(Fa.min),bi.expandByPoint(Fa.max))}bi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)On.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(On));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)On.fromBufferAttribute(a,l),c&&(Po.fromBufferAttribute(e,l),On.add(Po)),s=Math.max(s,n.distanceToSquared(On))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new ln(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let k=0;k<n.count;k++)a[k]=new V,c[k]=new V;let h=new V,u=new V,d=new V,f=new je,p=new je,v=new je,g=new V,m=new V;function y(k,D,L){l[k]=l[D]=l[L]=1,h.fromBufferAttribute(n,k),u.fromBufferAttribute(n,D),d.fromBufferAttribute(n,L),f.fromBufferAttribute(r,k),p.fromBufferAttribute(r,D),v.fromBufferAttribute(r,L),u.sub(h),d.sub(h),p.sub(f),v.sub(f);let W=1/(p.x*v.y-v.x*p.y);isFinite(W)&&(g.copy(u).multiplyScalar(v.y).addScaledVector(d,-p.y).multiplyScalar(W),m.copy(d).multiplyScalar(p.x).addScaledVector(u,-v.x).multiplyScalar(W),a[k].add(g),a[D].add(g),a[L].add(g),c[k].add(m),c[D].add(m),c[L].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let k=0,D=M.length;k<D;++k){let L=M[k],W=L.start,X=L.count;for(let O=W,H=W+X;O<H;O+=3)y(e.getX(O+0),e.getX(O+1),e.getX(O+2))}let b=new V,C=new V,A=new V,x=new V;function E(k){A.fromBufferAttribute(s,k),x.copy(A);let D=a[k];b.copy(D),b.sub(A.multiplyScalar(A.dot(D))).normalize(),C.crossVectors(x,D);let W=C.dot(c[k])<0?-1:1;o.setXYZW(k,b.x,b.y,b.z,W)}for(let k=0,D=n.count;k<D;++k)l[k]&&E(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new ln(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new V,r=new V,o=new V,a=new V,c=new V,l=new V,h=new V,u=new V;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),v=e.getX(d+1),g=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),c.fromBufferAttribute(n,v),l.fromBufferAttribute(n,g),a.add(h),c.add(h),l.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(v,c.x,c.y,c.z),n.setXYZ(g,l.x,l.y,l.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)On.fromBufferAttribute(e,t),On.normalize(),e.setXYZ(t,On.x,On.y,On.z)}toNonIndexed(){function e(a,c){let l=a.array,h=a.itemSize,u=a.normalized,d=new l.constructor(c.length*h),f=0,p=0;for(let v=0,g=c.length;v<g;v++){a.isInterleavedBufferAttribute?f=c[v]*a.data.stride+a.offset:f=c[v]*h;for(let m=0;m<h;m++)d[p++]=l[f++]}return new ln(d,h,u)}if(this.index===null)return qe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=e(c,n);t.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,u=l.length;h<u;h++){let d=l[h],f=e(d,n);c.push(f)}t.morphAttributes[a]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let c in n){let l=n[c];e.data.attributes[c]=l.toJSON(e.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let u=0,d=l.length;u<d;u++){let f=l[u];h.push(f.toJSON(e.data))}h.length>0&&(s[c]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(t))}let r=e.morphAttributes;for(let l in r){let h=[],u=r[l];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[l]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let l=0,h=o.length;l<h;l++){let u=o[l];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Wo=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Af,this.updateRanges=[],this.version=0,this.uuid=vs()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=xg(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=xg(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function xg(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=vs()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var ti=new V,Xo=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?Gh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)ti.fromBufferAttribute(this,t),ti.applyMatrix4(e),this.setXYZ(t,ti.x,ti.y,ti.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)ti.fromBufferAttribute(this,t),ti.applyNormalMatrix(e),this.setXYZ(t,ti.x,ti.y,ti.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)ti.fromBufferAttribute(this,t),ti.transformDirection(e),this.setXYZ(t,ti.x,ti.y,ti.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){qa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new ln(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){qa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):If(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Lf(e,this.data.array)}},Dd=new V,Vy=new V,Gy=new st,zn=class{constructor(e=new V(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Dd.subVectors(n,t).cross(Vy.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Dd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Gy.getNormalMatrix(e),s=this.coplanarPoint(Dd).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Wy=0,hi=class extends Ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Wy++}),this.uuid=vs(),this.name="",this.type="Material",this.blending=na,this.side=xs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=of,this.blendDst=af,this.blendEquation=Kr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ke(0,0,0),this.blendAlpha=0,this.depthFunc=Uo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=v0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ic,this.stencilZFail=Ic,this.stencilZPass=Ic,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){qe(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){qe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ke().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new zn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new je().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new je().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ds=new V,Od=new V,dc=new V,fc=new V,fs=class{constructor(e=new V,t=new V(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ds)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ds.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ds.copy(this.origin).addScaledVector(this.direction,t),Ds.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Od.copy(e).add(t).multiplyScalar(.5),dc.copy(t).sub(e).normalize(),fc.copy(this.origin).sub(Od);let r=e.distanceTo(t)*.5,o=-this.direction.dot(dc),a=fc.dot(this.direction),c=-fc.dot(dc),l=fc.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*c-a,d=o*a-c,p=r*h,u>=0)if(d>=-p)if(d<=p){let v=1/h;u*=v,d*=v,f=u*(u+o*d+2*a)+d*(o*u+d+2*c)+l}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l):d<=p?(u=0,d=Math.min(Math.max(-r,-c),r),f=d*(d+2*c)+l):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Od).addScaledVector(dc,d),f}intersectSphere(e,t){if(e.radius<0)return null;Ds.subVectors(e.center,this.origin);let n=Ds.dot(this.direction),s=Ds.dot(Ds)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return l>=0?(n=(e.min.x-d.x)*l,s=(e.max.x-d.x)*l):(n=(e.max.x-d.x)*l,s=(e.min.x-d.x)*l),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,c=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,c=(e.min.z-d.z)*u),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ds)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,v=t.y-o.y,g=t.z-o.z,m=n.x-o.x,y=n.y-o.y,M=n.z-o.z,b=Math.abs(c),C=Math.abs(l),A=Math.abs(h),x,E,k,D,L,W,X,O,H,Y,B,ce;if(b>=C&&b>=A?(k=c,W=u,H=p,ce=m,c>=0?(x=l,E=h,D=d,L=f,X=v,O=g,Y=y,B=M):(x=h,E=l,D=f,L=d,X=g,O=v,Y=M,B=y)):C>=A?(k=l,W=d,H=v,ce=y,l>=0?(x=h,E=c,D=f,L=u,X=g,O=p,Y=M,B=m):(x=c,E=h,D=u,L=f,X=p,O=g,Y=m,B=M)):(k=h,W=f,H=g,ce=M,h>=0?(x=c,E=l,D=u,L=d,X=p,O=v,Y=m,B=y):(x=l,E=c,D=d,L=u,X=v,O=p,Y=y,B=m)),k===0)return null;let Z=x/k,ee=E/k,se=1/k,fe=D-Z*W,de=L-ee*W,te=X-Z*H,ge=O-ee*H,ve=Y-Z*ce,Ce=B-ee*ce,Me=ve*ge-Ce*te,$e=fe*Ce-de*ve,at=te*de-ge*fe;if(s){if(Me<0||$e<0||at<0)return null}else if((Me<0||$e<0||at<0)&&(Me>0||$e>0||at>0))return null;let We=Me+$e+at;if(We===0)return null;let pt=se*(Me*W+$e*H+at*ce);return(We>0?pt<0:pt>0)?null:this.at(pt/We,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ui=class extends hi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ke(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ks,this.combine=lf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},_g=new ct,Fr=new fs,pc=new ci,vg=new V,mc=new V,gc=new V,xc=new V,Ud=new V,_c=new V,yg=new V,vc=new V,Zt=class extends jt{constructor(e=new Vn,t=new ui){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){_c.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],u=r[c];h!==0&&(Ud.fromBufferAttribute(u,e),o?_c.addScaledVector(Ud,h):_c.addScaledVector(Ud.sub(t),h))}t.add(_c)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),pc.copy(n.boundingSphere),pc.applyMatrix4(r),Fr.copy(e.ray).recast(e.near),!(pc.containsPoint(Fr.origin)===!1&&(Fr.intersectSphere(pc,vg)===null||Fr.origin.distanceToSquared(vg)>(e.far-e.near)**2))&&(_g.copy(r).invert(),Fr.copy(e.ray).applyMatrix4(_g),!(n.boundingBox!==null&&Fr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Fr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,v=d.length;p<v;p++){let g=d[p],m=o[g.materialIndex],y=Math.max(g.start,f.start),M=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let b=y,C=M;b<C;b+=3){let A=a.getX(b),x=a.getX(b+1),E=a.getX(b+2);s=yc(this,m,e,n,l,h,u,A,x,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let y=a.getX(g),M=a.getX(g+1),b=a.getX(g+2);s=yc(this,o,e,n,l,h,u,y,M,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let p=0,v=d.length;p<v;p++){let g=d[p],m=o[g.materialIndex],y=Math.max(g.start,f.start),M=Math.min(c.count,Math.min(g.start+g.count,f.start+f.count));for(let b=y,C=M;b<C;b+=3){let A=b,x=b+1,E=b+2;s=yc(this,m,e,n,l,h,u,A,x,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(c.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let y=g,M=g+1,b=g+2;s=yc(this,o,e,n,l,h,u,y,M,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function Xy(i,e,t,n,s,r,o,a){let c;if(e.side===ri?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(s,r,o,e.side===xs,a),c===null)return null;vc.copy(a),vc.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(vc);return l<t.near||l>t.far?null:{distance:l,point:vc.clone(),object:i}}function yc(i,e,t,n,s,r,o,a,c,l){i.getVertexPosition(a,mc),i.getVertexPosition(c,gc),i.getVertexPosition(l,xc);let h=Xy(i,e,t,n,mc,gc,xc,yg);if(h){let u=new V;dr.getBarycoord(yg,mc,gc,xc,u),s&&(h.uv=dr.getInterpolatedAttribute(s,a,c,l,u,new je)),r&&(h.uv1=dr.getInterpolatedAttribute(r,a,c,l,u,new je)),o&&(h.normal=dr.getInterpolatedAttribute(o,a,c,l,u,new V),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new V,materialIndex:0};dr.getNormal(mc,gc,xc,d.normal),h.face=d,h.barycoord=u}return h}var ka=new Dt,bg=new Dt,Sg=new Dt,qy=new Dt,Mg=new ct,bc=new V,Fd=new ci,wg=new ct,kd=new fs,Za=class extends Zt{constructor(e,t){super(e,t),this.isSkinnedMesh=!0,this.type="SkinnedMesh",this.bindMode=Vd,this.bindMatrix=new ct,this.bindMatrixInverse=new ct,this.boundingBox=null,this.boundingSphere=null}computeBoundingBox(){let e=this.geometry;this.boundingBox===null&&(this.boundingBox=new Hn),this.boundingBox.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,bc),this.boundingBox.expandByPoint(bc)}computeBoundingSphere(){let e=this.geometry;this.boundingSphere===null&&(this.boundingSphere=new ci),this.boundingSphere.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,bc),this.boundingSphere.expandByPoint(bc)}copy(e,t){return super.copy(e,t),this.bindMode=e.bindMode,this.bindMatrix.copy(e.bindMatrix),this.bindMatrixInverse.copy(e.bindMatrixInverse),this.skeleton=e.skeleton,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}raycast(e,t){let n=this.material,s=this.matrixWorld;n!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Fd.copy(this.boundingSphere),Fd.applyMatrix4(s),e.ray.intersectsSphere(Fd)!==!1&&(wg.copy(s).invert(),kd.copy(e.ray).applyMatrix4(wg),!(this.boundingBox!==null&&kd.intersectsBox(this.boundingBox)===!1)&&this._computeIntersections(e,t,kd)))}getVertexPosition(e,t){return super.getVertexPosition(e,t),this.applyBoneTransform(e,t),t}bind(e,t){this.skeleton=e,t===void 0&&(this.updateMatrixWorld(!0),this.skeleton.calculateInverses(),t=this.matrixWorld),this.bindMatrix.copy(t),this.bindMatrixInverse.copy(t).invert()}pose(){this.skeleton.pose()}normalizeSkinWeights(){let e=new Dt,t=this.geometry.attributes.skinWeight;for(let n=0,s=t.count;n<s;n++){e.fromBufferAttribute(t,n);let r=1/e.manhattanLength();r!==1/0?e.multiplyScalar(r):e.set(1,0,0,0),t.setXYZW(n,e.x,e.y,e.z,e.w)}}updateMatrixWorld(e){super.updateMatrixWorld(e),this.bindMode===Vd?this.bindMatrixInverse.copy(this.matrixWorld).invert():this.bindMode===m0?this.bindMatrixInverse.copy(this.bindMatrix).invert():qe("SkinnedMesh: Unrecognized bindMode: "+this.bindMode)}applyBoneTransform(e,t){let n=this.skeleton,s=this.geometry;bg.fromBufferAttribute(s.attributes.skinIndex,e),Sg.fromBufferAttribute(s.attributes.skinWeight,e),t.isVector4?(ka.copy(t),t.set(0,0,0,0)):(ka.set(t.x,t.y,t.z,1),t.set(0,0,0)),ka.applyMatrix4(this.bindMatrix);for(let r=0;r<4;r++){let o=Sg.getComponent(r);if(o!==0){let a=bg.getComponent(r);Mg.multiplyMatrices(n.bones[a].matrixWorld,n.boneInverses[a]),t.addScaledVector(qy.copy(ka).applyMatrix4(Mg),o)}}return t.isVector4&&(t.w=ka.w),t.applyMatrix4(this.bindMatrixInverse)}},qo=class extends jt{constructor(){super(),this.isBone=!0,this.type="Bone"}},$o=class extends kn{constructor(e=null,t=1,n=1,s,r,o,a,c,l=cn,h=cn,u,d){super(null,o,a,c,l,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}},Tg=new ct,$y=new ct,Ja=class i{constructor(e=[],t=[]){this.uuid=vs(),this.bones=e.slice(0),this.boneInverses=t,this.boneMatrices=null,this.previousBoneMatrices=null,this.boneTexture=null,this.previousBoneTexture=null,this.init()}init(){let e=this.bones,t=this.boneInverses;if(this.boneMatrices=new Float32Array(e.length*16),t.length===0)this.calculateInverses();else if(e.length!==t.length){qe("Skeleton: Number of inverse bone matrices does not match amount of bones."),this.boneInverses=[];for(let n=0,s=this.bones.length;n<s;n++)this.boneInverses.push(new ct)}}calculateInverses(){this.boneInverses.length=0;for(let e=0,t=this.bones.length;e<t;e++){let n=new ct;this.bones[e]&&n.copy(this.bones[e].matrixWorld).invert(),this.boneInverses.push(n)}}pose(){for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&n.matrixWorld.copy(this.boneInverses[e]).invert()}for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&(n.parent&&n.parent.isBone?(n.matrix.copy(n.parent.matrixWorld).invert(),n.matrix.multiply(n.matrixWorld)):n.matrix.copy(n.matrixWorld),n.matrix.decompose(n.position,n.quaternion,n.scale))}}update(){let e=this.bones,t=this.boneInverses,n=this.boneMatrices,s=this.boneTexture;for(let r=0,o=e.length;r<o;r++){let a=e[r]?e[r].matrixWorld:$y;Tg.multiplyMatrices(a,t[r]),Tg.toArray(n,r*16)}s!==null&&(s.needsUpdate=!0)}clone(){return new i(this.bones,this.boneInverses)}computeBoneTexture(){let e=Math.sqrt(this.bones.length*4);e=Math.ceil(e/4)*4,e=Math.max(e,4);let t=new Float32Array(e*e*4);t.set(this.boneMatrices);let n=new $o(t,e,e,ki,Mi);return n.needsUpdate=!0,this.boneMatrices=t,this.boneTexture=n,this}getBoneByName(e){for(let t=0,n=this.bones.length;t<n;t++){let s=this.bones[t];if(s.name===e)return s}}dispose(){this.boneTexture!==null&&(this.boneTexture.dispose(),this.boneTexture=null),this.previousBoneTexture!==null&&(this.previousBoneTexture.dispose(),this.previousBoneTexture=null)}fromJSON(e,t){this.uuid=e.uuid;for(let n=0,s=e.bones.length;n<s;n++){let r=e.bones[n],o=t[r];o===void 0&&(qe("Skeleton: No bone found with UUID:",r),o=new qo),this.bones.push(o),this.boneInverses.push(new ct().fromArray(e.boneInverses[n]))}return this.init(),this}toJSON(){let e={metadata:{version:4.7,type:"Skeleton",generator:"Skeleton.toJSON"},bones:[],boneInverses:[]};e.uuid=this.uuid;let t=this.bones,n=this.boneInverses;for(let s=0,r=t.length;s<r;s++){let o=t[s];e.bones.push(o.uuid);let a=n[s];e.boneInverses.push(a.toArray())}return e}},Bs=class extends ln{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Io=new ct,Eg=new ct,Sc=[],Ag=new Hn,Yy=new ct,Ba=new Zt,za=new ci,Qa=class extends Zt{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Bs(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Yy)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Hn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Io),Ag.copy(e.boundingBox).applyMatrix4(Io),this.boundingBox.union(Ag)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new ci),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Io),za.copy(e.boundingSphere).applyMatrix4(Io),this.boundingSphere.union(za)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(Ba.geometry=this.geometry,Ba.material=this.material,Ba.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),za.copy(this.boundingSphere),za.applyMatrix4(n),e.ray.intersectsSphere(za)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Io),Eg.multiplyMatrices(n,Io),Ba.matrixWorld=Eg,Ba.raycast(e,Sc);for(let o=0,a=Sc.length;o<a;o++){let c=Sc[o];c.instanceId=r,c.object=this,t.push(c)}Sc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Bs(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new $o(new Float32Array(s*this.count),s,this.count,lh,Mi));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<n.length;l++)o+=n[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*e;return r[c]=a,r.set(n,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},kr=new ci,Ky=new je(.5,.5),Mc=new V,pr=class{constructor(e=new zn,t=new zn,n=new zn,s=new zn,r=new zn,o=new zn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ui,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],v=r[9],g=r[10],m=r[11],y=r[12],M=r[13],b=r[14],C=r[15];if(s[0].setComponents(l-o,f-h,m-p,C-y).normalize(),s[1].setComponents(l+o,f+h,m+p,C+y).normalize(),s[2].setComponents(l+a,f+u,m+v,C+M).normalize(),s[3].setComponents(l-a,f-u,m-v,C-M).normalize(),n)s[4].setComponents(c,d,g,b).normalize(),s[5].setComponents(l-c,f-d,m-g,C-b).normalize();else if(s[4].setComponents(l-c,f-d,m-g,C-b).normalize(),t===Ui)s[5].setComponents(l+c,f+d,m+g,C+b).normalize();else if(t===ko)s[5].setComponents(c,d,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),kr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),kr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(kr)}intersectsSprite(e){kr.center.set(0,0,0);let t=Ky.distanceTo(e.center);return kr.radius=.7071067811865476+t,kr.applyMatrix4(e.matrixWorld),this.intersectsSphere(kr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Mc.x=s.normal.x>0?e.max.x:e.min.x,Mc.y=s.normal.y>0?e.max.y:e.min.y,Mc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Mc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Rg=new ct,Vc=class i{constructor(){this.coordinateSystem=Ui,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Rg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new pr),n[s].setFromProjectionMatrix(Rg,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new pr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Yo=class extends hi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ke(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Gc=new V,Wc=new V,Cg=new ct,Ha=new fs,wc=new ci,Bd=new V,Pg=new V,Gr=class extends jt{constructor(e=new Vn,t=new Yo){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Gc.fromBufferAttribute(t,s-1),Wc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Gc.distanceTo(Wc);e.setAttribute("lineDistance",new Un(n,1))}else qe("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),wc.copy(n.boundingSphere),wc.applyMatrix4(s),wc.radius+=r,e.ray.intersectsSphere(wc)===!1)return;Cg.copy(s).invert(),Ha.copy(e.ray).applyMatrix4(Cg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let v=f,g=p-1;v<g;v+=l){let m=h.getX(v),y=h.getX(v+1),M=Tc(this,e,Ha,c,m,y,v);M&&t.push(M)}if(this.isLineLoop){let v=h.getX(p-1),g=h.getX(f),m=Tc(this,e,Ha,c,v,g,p-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let v=f,g=p-1;v<g;v+=l){let m=Tc(this,e,Ha,c,v,v+1,v);m&&t.push(m)}if(this.isLineLoop){let v=Tc(this,e,Ha,c,p-1,f,p-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Tc(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Gc.fromBufferAttribute(a,s),Wc.fromBufferAttribute(a,r),t.distanceSqToSegment(Gc,Wc,Bd,Pg)>n)return;Bd.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(Bd);if(!(l<e.near||l>e.far))return{distance:l,point:Pg.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Ig=new V,Lg=new V,el=class extends Gr{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Ig.fromBufferAttribute(t,s),Lg.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Ig.distanceTo(Lg);e.setAttribute("lineDistance",new Un(n,1))}else qe("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},tl=class extends Gr{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}},Ko=class extends hi{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ke(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},Ng=new ct,$d=new fs,Ec=new ci,Ac=new V,nl=class extends jt{constructor(e=new Vn,t=new Ko){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ec.copy(n.boundingSphere),Ec.applyMatrix4(s),Ec.radius+=r,e.ray.intersectsSphere(Ec)===!1)return;Ng.copy(s).invert(),$d.copy(e.ray).applyMatrix4(Ng);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=n.index,u=n.attributes.position;if(l!==null){let d=Math.max(0,o.start),f=Math.min(l.count,o.start+o.count);for(let p=d,v=f;p<v;p++){let g=l.getX(p);Ac.fromBufferAttribute(u,g),Dg(Ac,g,c,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let p=d,v=f;p<v;p++)Ac.fromBufferAttribute(u,p),Dg(Ac,p,c,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Dg(i,e,t,n,s,r,o){let a=$d.distanceSqToPoint(i);if(a<t){let c=new V;$d.closestPointToPoint(i,c),c.applyMatrix4(n);let l=s.ray.origin.distanceTo(c);if(l<s.near||l>s.far)return;r.push({distance:l,distanceToRay:Math.sqrt(a),point:c,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var il=class extends kn{constructor(e=[],t=jr,n,s,r,o,a,c,l,h){super(e,t,n,s,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var zs=class extends kn{constructor(e,t,n=ji,s,r,o,a=cn,c=cn,l,h=Fs,u=1){if(h!==Fs&&h!==$s)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Ho(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},sl=class extends zs{constructor(e,t=ji,n=jr,s,r,o=cn,a=cn,c,l=Fs){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,c,l),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},rl=class extends kn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},jo=class i extends Vn{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new Un(l,3)),this.setAttribute("normal",new Un(h,3)),this.setAttribute("uv",new Un(u,2));function p(v,g,m,y,M,b,C,A,x,E,k){let D=b/x,L=C/E,W=b/2,X=C/2,O=A/2,H=x+1,Y=E+1,B=0,ce=0,Z=new V;for(let ee=0;ee<Y;ee++){let se=ee*L-X;for(let fe=0;fe<H;fe++){let de=fe*D-W;Z[v]=de*y,Z[g]=se*M,Z[m]=O,l.push(Z.x,Z.y,Z.z),Z[v]=0,Z[g]=0,Z[m]=A>0?1:-1,h.push(Z.x,Z.y,Z.z),u.push(fe/x),u.push(1-ee/E),B+=1}}for(let ee=0;ee<E;ee++)for(let se=0;se<x;se++){let fe=d+se+H*ee,de=d+se+H*(ee+1),te=d+(se+1)+H*(ee+1),ge=d+(se+1)+H*ee;c.push(fe,de,ge),c.push(de,te,ge),ce+=6}a.addGroup(f,ce,k),f+=ce,d+=B}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var ol=class i extends Vn{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),c=Math.floor(s),l=a+1,h=c+1,u=e/a,d=t/c,f=[],p=[],v=[],g=[];for(let m=0;m<h;m++){let y=m*d-o;for(let M=0;M<l;M++){let b=M*u-r;p.push(b,-y,0),v.push(0,0,1),g.push(M/a),g.push(1-m/c)}}for(let m=0;m<c;m++)for(let y=0;y<a;y++){let M=y+l*m,b=y+l*(m+1),C=y+1+l*(m+1),A=y+1+l*m;f.push(M,b,A),f.push(b,C,A)}this.setIndex(f),this.setAttribute("position",new Un(p,3)),this.setAttribute("normal",new Un(v,3)),this.setAttribute("uv",new Un(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Wr=class i extends Vn{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let c=Math.min(o+a,Math.PI),l=0,h=[],u=new V,d=new V,f=[],p=[],v=[],g=[];for(let m=0;m<=n;m++){let y=[],M=m/n,b=o+M*a,C=e*Math.cos(b),A=Math.sqrt(e*e-C*C),x=0;m===0&&o===0?x=.5/t:m===n&&c===Math.PI&&(x=-.5/t);for(let E=0;E<=t;E++){let k=E/t,D=s+k*r;u.x=-A*Math.cos(D),u.y=C,u.z=A*Math.sin(D),p.push(u.x,u.y,u.z),d.copy(u).normalize(),v.push(d.x,d.y,d.z),g.push(k+x,1-M),y.push(l++)}h.push(y)}for(let m=0;m<n;m++)for(let y=0;y<t;y++){let M=h[m][y+1],b=h[m][y],C=h[m+1][y],A=h[m+1][y+1];(m!==0||o>0)&&f.push(M,b,A),(m!==n-1||c<Math.PI)&&f.push(b,C,A)}this.setIndex(f),this.setAttribute("position",new Un(p,3)),this.setAttribute("normal",new Un(v,3)),this.setAttribute("uv",new Un(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Qr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Og(s))s.isRenderTargetTexture?(qe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Og(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Yn(i){let e={};for(let t=0;t<i.length;t++){let n=Qr(i[t]);for(let s in n)e[s]=n[s]}return e}function Og(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function jy(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Nf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:mt.workingColorSpace}var P0={clone:Qr,merge:Yn},Zy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Jy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ps=class extends hi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Zy,this.fragmentShader=Jy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Qr(e.uniforms),this.uniformsGroups=jy(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Ke().setHex(s.value);break;case"v2":this.uniforms[n].value=new je().fromArray(s.value);break;case"v3":this.uniforms[n].value=new V().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Dt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new st().fromArray(s.value);break;case"m4":this.uniforms[n].value=new ct().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Xc=class extends ps{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Hs=class extends hi{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Ke(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ke(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Vh,this.normalScale=new je(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ks,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},si=class extends Hs{constructor(e){super(),this.isMeshPhysicalMaterial=!0,this.defines={STANDARD:"",PHYSICAL:""},this.type="MeshPhysicalMaterial",this.anisotropyRotation=0,this.anisotropyMap=null,this.clearcoatMap=null,this.clearcoatRoughness=0,this.clearcoatRoughnessMap=null,this.clearcoatNormalScale=new je(1,1),this.clearcoatNormalMap=null,this.diffuseRoughnessMap=null,this.ior=1.5,Object.defineProperty(this,"reflectivity",{get:function(){return gt(2.5*(this.ior-1)/(this.ior+1),0,1)},set:function(t){this.ior=(1+.4*t)/(1-.4*t)}}),this.iridescenceMap=null,this.iridescenceIOR=1.3,this.iridescenceThicknessMinimum=100,this.iridescenceThicknessMaximum=400,this.iridescenceThicknessMap=null,this.sheenColor=new Ke(0),this.sheenColorMap=null,this.sheenRoughness=1,this.sheenRoughnessMap=null,this.transmissionMap=null,this.thickness=0,this.thicknessMap=null,this.attenuationDistance=1/0,this.attenuationColor=new Ke(1,1,1),this.specularIntensity=1,this.specularIntensityMap=null,this.specularColor=new Ke(1,1,1),this.specularColorMap=null,this._anisotropy=0,this._clearcoat=0,this._diffuseRoughness=0,this._dispersion=0,this._iridescence=0,this._retroreflectivity=0,this._sheen=0,this._transmission=0,this.setValues(e)}get anisotropy(){return this._anisotropy}set anisotropy(e){this._anisotropy>0!=e>0&&this.version++,this._anisotropy=e}get clearcoat(){return this._clearcoat}set clearcoat(e){this._clearcoat>0!=e>0&&this.version++,this._clearcoat=e}get diffuseRoughness(){return this._diffuseRoughness}set diffuseRoughness(e){this._diffuseRoughness>0!=e>0&&this.version++,this._diffuseRoughness=e}get iridescence(){return this._iridescence}set iridescence(e){this._iridescence>0!=e>0&&this.version++,this._iridescence=e}get dispersion(){return this._dispersion}set dispersion(e){this._dispersion>0!=e>0&&this.version++,this._dispersion=e}get retroreflectivity(){return this._retroreflectivity}set retroreflectivity(e){this._retroreflectivity>0!=e>0&&this.version++,this._retroreflectivity=e}get sheen(){return this._sheen}set sheen(e){this._sheen>0!=e>0&&this.version++,this._sheen=e}get transmission(){return this._transmission}set transmission(e){this._transmission>0!=e>0&&this.version++,this._transmission=e}get iridescenceThicknessRange(){return Br('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),[this.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum]}set iridescenceThicknessRange(e){Br('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),this.iridescenceThicknessMinimum=e[0],this.iridescenceThicknessMaximum=e[1]}copy(e){return super.copy(e),this.defines={STANDARD:"",PHYSICAL:""},this.anisotropy=e.anisotropy,this.anisotropyRotation=e.anisotropyRotation,this.anisotropyMap=e.anisotropyMap,this.clearcoat=e.clearcoat,this.clearcoatMap=e.clearcoatMap,this.clearcoatRoughness=e.clearcoatRoughness,this.clearcoatRoughnessMap=e.clearcoatRoughnessMap,this.clearcoatNormalMap=e.clearcoatNormalMap,this.clearcoatNormalScale.copy(e.clearcoatNormalScale),this.diffuseRoughness=e.diffuseRoughness,this.diffuseRoughnessMap=e.diffuseRoughnessMap,this.dispersion=e.dispersion,this.ior=e.ior,this.iridescence=e.iridescence,this.iridescenceMap=e.iridescenceMap,this.iridescenceIOR=e.iridescenceIOR,this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum,this.iridescenceThicknessMap=e.iridescenceThicknessMap,this.retroreflectivity=e.retroreflectivity,this.sheen=e.sheen,this.sheenColor.copy(e.sheenColor),this.sheenColorMap=e.sheenColorMap,this.sheenRoughness=e.sheenRoughness,this.sheenRoughnessMap=e.sheenRoughnessMap,this.transmission=e.transmission,this.transmissionMap=e.transmissionMap,this.thickness=e.thickness,this.thicknessMap=e.thicknessMap,this.attenuationDistance=e.attenuationDistance,this.attenuationColor.copy(e.attenuationColor),this.specularIntensity=e.specularIntensity,this.specularIntensityMap=e.specularIntensityMap,this.specularColor.copy(e.specularColor),this.specularColorMap=e.specularColorMap,this}};var qc=class extends hi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=x0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},$c=class extends hi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function ur(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Va(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}function Qy(i){function e(s,r){return i[s]-i[r]}let t=i.length,n=new Array(t);for(let s=0;s!==t;++s)n[s]=s;return n.sort(e),n}function Ug(i,e,t){let n=i.length,s=new i.constructor(n);for(let r=0,o=0;o!==n;++r){let a=t[r]*e;for(let c=0;c!==e;++c)s[o++]=i[a+c]}return s}function eb(i,e,t,n){let s=1,r=i[0];for(;r!==void 0&&r[n]===void 0;)r=i[s++];if(r===void 0)return;let o=r[n];if(o!==void 0)if(Array.isArray(o))do o=r[n],o!==void 0&&(e.push(r.time),t.push(...o)),r=i[s++];while(r!==void 0);else if(o.toArray!==void 0)do o=r[n],o!==void 0&&(e.push(r.time),o.toArray(t,t.length)),r=i[s++];while(r!==void 0);else do o=r[n],o!==void 0&&(e.push(r.time),t.push(o)),r=i[s++];while(r!==void 0)}var ms=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Yc=class extends ms{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Wd,endingEnd:Wd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Xd:r=e,a=2*t-n;break;case qd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Xd:o=e,c=2*n-t;break;case qd:o=1,c=n+s[1]-s[0];break;default:o=e-1,c=t}let l=(n-t)*.5,h=this.valueSize;this._weightPrev=l/(t-a),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),v=p*p,g=v*p,m=-d*g+2*d*v-d*p,y=(1+d)*g+(-1.5-2*d)*v+(-.5+d)*p+1,M=(-1-f)*g+(1.5+f)*v+.5*p,b=f*g-f*v;for(let C=0;C!==a;++C)r[C]=m*o[h+C]+y*o[l+C]+M*o[c+C]+b*o[u+C];return r}},Kc=class extends ms{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[l+d]*u+o[c+d]*h;return r}},jc=class extends ms{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Zc=class extends ms{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-t)/(s-t),v=1-p;for(let g=0;g!==a;++g)r[g]=o[l+g]*v+o[c+g]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let v=o[l+p],g=o[c+p],m=f*d+p*2,y=u[m],M=u[m+1],b=e*d+p*2,C=h[b],A=h[b+1],x=nb(n,t,y,C,s);r[p]=I0(x,v,M,A,g)}return r}};function I0(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function tb(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function nb(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=I0(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let c=tb(r,e,t,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var di=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=ur(t,this.TimeBufferType),this.values=ur(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:ur(e.times,Array),values:ur(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Va(e.settings)&&(n.settings={inTangents:ur(e.settings.inTangents,Array),outTangents:ur(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new jc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Kc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Yc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Zc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case zr:t=this.InterpolantFactoryMethodDiscrete;break;case Hr:t=this.InterpolantFactoryMethodLinear;break;case Pc:t=this.InterpolantFactoryMethodSmooth;break;case Gd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return qe("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return zr;case this.InterpolantFactoryMethodLinear:return Hr;case this.InterpolantFactoryMethodSmooth:return Pc;case this.InterpolantFactoryMethodBezier:return Gd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Va(this.settings)&&(Fg(this.settings.inTangents,e),Fg(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Va(this.settings)&&(kg(this.settings.inTangents,e),kg(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){nt("KeyframeTrack: Time is not a valid number.",this,a,c),e=!1;break}if(o!==null&&o>c){nt("KeyframeTrack: Out of order keys.",this,a,c,o),e=!1;break}o=c}if(s!==void 0&&fy(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){nt("KeyframeTrack: Value is not a valid number.",this,a,l),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Pc,r=e.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=e[a],h=e[a+1];if(l!==h&&(a!==1||l!==e[0]))if(s)c=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let v=t[u+p];if(v!==t[d+p]||v!==t[f+p]){c=!0;break}}}if(c){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)t[c+l]=t[a+l];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Va(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Fg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function kg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}di.prototype.ValueTypeName="";di.prototype.TimeBufferType=Float32Array;di.prototype.ValueBufferType=Float32Array;di.prototype.DefaultInterpolation=Hr;var Vs=class extends di{constructor(e,t,n){super(e,t,n)}};Vs.prototype.ValueTypeName="bool";Vs.prototype.ValueBufferType=Array;Vs.prototype.DefaultInterpolation=zr;Vs.prototype.InterpolantFactoryMethodLinear=void 0;Vs.prototype.InterpolantFactoryMethodSmooth=void 0;var al=class extends di{constructor(e,t,n,s){super(e,t,n,s)}};al.prototype.ValueTypeName="color";var Gs=class extends di{constructor(e,t,n,s){super(e,t,n,s)}};Gs.prototype.ValueTypeName="number";var Jc=class extends ms{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-t)/(s-t),l=e*a;for(let h=l+a;l!==h;l+=4)Fn.slerpFlat(r,0,o,l-a,o,l,c);return r}},Ws=class extends di{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Jc(this.times,this.values,this.getValueSize(),e)}};Ws.prototype.ValueTypeName="quaternion";Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var Xs=class extends di{constructor(e,t,n){super(e,t,n)}};Xs.prototype.ValueTypeName="string";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=zr;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var mr=class extends di{constructor(e,t,n,s){super(e,t,n,s)}};mr.prototype.ValueTypeName="vector";var ll=class{constructor(e="",t=-1,n=[],s=g0){this.name=e,this.tracks=n,this.duration=t,this.blendMode=s,this.uuid=vs(),this.userData={},this.duration<0&&this.resetDuration()}static parse(e){let t=[],n=e.tracks,s=1/(e.fps||1);for(let o=0,a=n.length;o!==a;++o)t.push(sb(n[o]).scale(s));let r=new this(e.name,e.duration,t,e.blendMode);return r.uuid=e.uuid,r.userData=JSON.parse(e.userData||"{}"),r}static toJSON(e){let t=[],n=e.tracks,s={name:e.name,duration:e.duration,tracks:t,uuid:e.uuid,blendMode:e.blendMode,userData:JSON.stringify(e.userData)};for(let r=0,o=n.length;r!==o;++r)t.push(di.toJSON(n[r]));return s}static CreateFromMorphTargetSequence(e,t,n,s){let r=t.length,o=[];for(let a=0;a<r;a++){let c=[],l=[];c.push((a+r-1)%r,a,(a+1)%r),l.push(0,1,0);let h=Qy(c);c=Ug(c,1,h),l=Ug(l,1,h),!s&&c[0]===0&&(c.push(r),l.push(l[0])),o.push(new Gs(".morphTargetInfluences["+t[a].name+"]",c,l).scale(1/n))}return new this(e,-1,o)}static findByName(e,t){let n=e;if(!Array.isArray(e)){let s=e;n=s.geometry&&s.geometry.animations||s.animations}for(let s=0;s<n.length;s++)if(n[s].name===t)return n[s];return null}static CreateClipsFromMorphTargetSequences(e,t,n){let s={},r=/^([\w-]*?)([\d]+)$/;for(let a=0,c=e.length;a<c;a++){let l=e[a],h=l.name.match(r);if(h&&h.length>1){let u=h[1],d=s[u];d||(s[u]=d=[]),d.push(l)}}let o=[];for(let a in s)o.push(this.CreateFromMorphTargetSequence(a,s[a],t,n));return o}resetDuration(){let e=this.tracks,t=0;for(let n=0,s=e.length;n!==s;++n){let r=this.tracks[n];t=Math.max(t,r.times[r.times.length-1])}return this.duration=t,this}trim(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].trim(0,this.duration);return this}validate(){let e=!0;for(let t=0;t<this.tracks.length;t++)e=e&&this.tracks[t].validate();return e}optimize(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].optimize();return this}clone(){let e=[];for(let n=0;n<this.tracks.length;n++)e.push(this.tracks[n].clone());let t=new this.constructor(this.name,this.duration,e,this.blendMode);return t.userData=JSON.parse(JSON.stringify(this.userData)),t}toJSON(){return this.constructor.toJSON(this)}};function ib(i){switch(i.toLowerCase()){case"scalar":case"double":case"float":case"number":case"integer":return Gs;case"vector":case"vector2":case"vector3":case"vector4":return mr;case"color":return al;case"quaternion":return Ws;case"bool":case"boolean":return Vs;case"string":return Xs}throw new Error("THREE.KeyframeTrack: Unsupported typeName: "+i)}function sb(i){if(i.type===void 0)throw new Error("THREE.KeyframeTrack: track type undefined, can not parse");let e=ib(i.type);if(i.times===void 0){let n=[],s=[];eb(i.keys,n,s,"value"),i.times=n,i.values=s}let t;return e.parse!==void 0?t=e.parse(i):t=new e(i.name,i.times,i.values,i.interpolation),Va(i.settings)&&(t.settings={inTangents:ur(i.settings.inTangents,Float32Array),outTangents:ur(i.settings.outTangents,Float32Array)}),t}var ds={enabled:!1,files:{},add:function(i,e){this.enabled!==!1&&(Bg(i)||(this.files[i]=e))},get:function(i){if(this.enabled!==!1&&!Bg(i))return this.files[i]},remove:function(i){delete this.files[i]},clear:function(){this.files={}}};function Bg(i){try{let e=i.slice(i.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var Qc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,u){return l.push(h,u),this},this.removeHandler=function(h){let u=l.indexOf(h);return u!==-1&&l.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=l.length;u<d;u+=2){let f=l[u],p=l[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},L0=new Qc,gs=class{constructor(e){this.manager=e!==void 0?e:L0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};gs.DEFAULT_MATERIAL_NAME="__DEFAULT";var Os={},Yd=class extends Error{constructor(e,t){super(e),this.response=t}},Zo=class extends gs{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=ds.get(`file:${e}`);if(r!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0);return}if(Os[e]!==void 0){Os[e].push({onLoad:t,onProgress:n,onError:s});return}Os[e]=[],Os[e].push({onLoad:t,onProgress:n,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,c=this.responseType;fetch(o).then(l=>{if(l.status===200||l.status===0){if(l.status===0&&qe("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||l.body===void 0||l.body.getReader===void 0)return l;let h=Os[e],u=l.body.getReader(),d=l.headers.get("X-File-Size")||l.headers.get("Content-Length"),f=d?parseInt(d):0,p=f!==0,v=0,g=new ReadableStream({start(m){y();function y(){u.read().then(({done:M,value:b})=>{if(M)m.close();else{v+=b.byteLength;let C=new ProgressEvent("progress",{lengthComputable:p,loaded:v,total:f});for(let A=0,x=h.length;A<x;A++){let E=h[A];E.onProgress&&E.onProgress(C)}m.enqueue(b),y()}},M=>{m.error(M)})}}});return new Response(g)}else throw new Yd(`fetch for "${l.url}" responded with ${l.status}: ${l.statusText}`,l)}).then(l=>{switch(c){case"arraybuffer":return l.arrayBuffer();case"blob":return l.blob();case"document":return l.text().then(h=>new DOMParser().parseFromString(h,a));case"json":return l.json();default:if(a==="")return l.text();{let u=/charset="?([^;"\s]*)"?/i.exec(a),d=u&&u[1]?u[1].toLowerCase():void 0,f=new TextDecoder(d);return l.arrayBuffer().then(p=>f.decode(p))}}}).then(l=>{ds.add(`file:${e}`,l);let h=Os[e];delete Os[e];for(let u=0,d=h.length;u<d;u++){let f=h[u];f.onLoad&&f.onLoad(l)}}).catch(l=>{let h=Os[e];if(h===void 0)throw this.manager.itemError(e),l;delete Os[e];for(let u=0,d=h.length;u<d;u++){let f=h[u];f.onError&&f.onError(l)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var Lo=new WeakMap,eh=class extends gs{constructor(e){super(e)}load(e,t,n,s){this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=this,o=ds.get(`image:${e}`);if(o!==void 0){if(o.complete===!0)r.manager.itemStart(e),setTimeout(function(){t&&t(o),r.manager.itemEnd(e)},0);else{let u=Lo.get(o);u===void 0&&(u=[],Lo.set(o,u)),u.push({onLoad:t,onError:s})}return o}let a=Bo("img");function c(){h(),t&&t(this);let u=Lo.get(this)||[];for(let d=0;d<u.length;d++){let f=u[d];f.onLoad&&f.onLoad(this)}Lo.delete(this),r.manager.itemEnd(e)}function l(u){h(),s&&s(u),ds.remove(`image:${e}`);let d=Lo.get(this)||[];for(let f=0;f<d.length;f++){let p=d[f];p.onError&&p.onError(u)}Lo.delete(this),r.manager.itemError(e),r.manager.itemEnd(e)}function h(){a.removeEventListener("load",c,!1),a.removeEventListener("error",l,!1)}return a.addEventListener("load",c,!1),a.addEventListener("error",l,!1),e.slice(0,5)!=="data:"&&this.crossOrigin!==void 0&&(a.crossOrigin=this.crossOrigin),ds.add(`image:${e}`,a),r.manager.itemStart(e),a.fetchPriority=this.priority,a.src=e,a}};var cl=class extends gs{constructor(e){super(e)}load(e,t,n,s){let r=new kn,o=new eh(this.manager);return o.setPriority(this.priority),o.setCache(this.cache),o.setCrossOrigin(this.crossOrigin),o.setPath(this.path),o.load(e,function(a){r.image=a,r.needsUpdate=!0,t!==void 0&&t(r)},n,s),r}},gr=class extends jt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Ke(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},hl=class extends gr{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(jt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ke(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},zd=new ct,zg=new V,Hg=new V,Jo=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new je(512,512),this.mapType=pi,this.map=null,this.mapPass=null,this.matrix=new ct,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new pr,this._frameExtents=new je(1,1),this._viewportCount=1,this._viewports=[new Dt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;zg.setFromMatrixPosition(e.matrixWorld),t.position.copy(zg),Hg.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Hg),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){zd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(zd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;e.coordinateSystem===ko||e.reversedDepth?t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),t.multiply(zd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Rc=new V,Cc=new Fn,us=new V,ul=class extends jt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ct,this.projectionMatrix=new ct,this.projectionMatrixInverse=new ct,this.coordinateSystem=Ui,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Rc,Cc,us),us.x===1&&us.y===1&&us.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Rc,Cc,us.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Rc,Cc,us),us.x===1&&us.y===1&&us.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Rc,Cc,us.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},hr=new V,Vg=new je,Gg=new je,bn=class extends ul{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Vr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ga*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Vr*2*Math.atan(Math.tan(Ga*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){hr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(hr.x,hr.y).multiplyScalar(-e/hr.z),hr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(hr.x,hr.y).multiplyScalar(-e/hr.z)}getViewSize(e,t){return this.getViewBounds(e,Vg,Gg),t.subVectors(Gg,Vg)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ga*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,t-=o.offsetY*n/l,s*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},Kd=class extends Jo{constructor(){super(new bn(50,1,.5,500)),this.isSpotLightShadow=!0,this.focus=1,this.aspect=1}updateMatrices(e){let t=this.camera,n=Vr*2*e.angle*this.focus,s=this.mapSize.width/this.mapSize.height*this.aspect,r=e.distance||t.far;(n!==t.fov||s!==t.aspect||r!==t.far)&&(t.fov=n,t.aspect=s,t.far=r,t.updateProjectionMatrix()),super.updateMatrices(e)}copy(e){return super.copy(e),this.focus=e.focus,this.aspect=e.aspect,this}toJSON(){let e=super.toJSON();return e.focus=this.focus,e.aspect=this.aspect,e}},dl=class extends gr{constructor(e,t,n=0,s=Math.PI/3,r=0,o=2){super(e,t),this.isSpotLight=!0,this.type="SpotLight",this.position.copy(jt.DEFAULT_UP),this.updateMatrix(),this.target=new jt,this.distance=n,this.angle=s,this.penumbra=r,this.decay=o,this.map=null,this.shadow=new Kd}get power(){return this.intensity*Math.PI}set power(e){this.intensity=e/Math.PI}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.angle=e.angle,this.penumbra=e.penumbra,this.decay=e.decay,this.target=e.target.clone(),this.map=e.map,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.angle=this.angle,t.object.decay=this.decay,t.object.penumbra=this.penumbra,t.object.target=this.target.uuid,this.map&&this.map.isTexture&&(t.object.map=this.map.toJSON(e).uuid),t.object.shadow=this.shadow.toJSON(),t}},jd=class extends Jo{constructor(){super(new bn(90,1,.5,500)),this.isPointLightShadow=!0}},fl=class extends gr{constructor(e,t,n=0,s=2){super(e,t),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=s,this.shadow=new jd}get power(){return this.intensity*4*Math.PI}set power(e){this.intensity=e/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.decay=e.decay,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.decay=this.decay,t.object.shadow=this.shadow.toJSON(),t}},Xr=class extends ul{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,c=s-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Zd=class extends Jo{constructor(){super(new Xr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},qr=class extends gr{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(jt.DEFAULT_UP),this.updateMatrix(),this.target=new jt,this.shadow=new Zd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},pl=class extends gr{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var qs=class{static extractUrlBase(e){let t=e.lastIndexOf("/");return t===-1?"./":e.slice(0,t+1)}static resolveURL(e,t){return typeof e!="string"||e===""?"":(/^https?:\/\//i.test(t)&&/^\//.test(e)&&(t=t.replace(/(^https?:\/\/[^\/]+).*/i,"$1")),/^(https?:)?\/\//i.test(e)||/^data:.*,.*$/i.test(e)||/^blob:.*$/i.test(e)?e:t+e)}};var Hd=new WeakMap,ml=class extends gs{constructor(e){super(e),this.isImageBitmapLoader=!0,typeof createImageBitmap>"u"&&qe("ImageBitmapLoader: createImageBitmap() not supported."),typeof fetch>"u"&&qe("ImageBitmapLoader: fetch() not supported."),this.options={premultiplyAlpha:"none"},this._abortController=new AbortController}setOptions(e){return this.options=e,this}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=this,o=ds.get(`image-bitmap:${e}`);if(o!==void 0){if(r.manager.itemStart(e),o.then){o.then(l=>{Hd.has(o)===!0?(s&&s(Hd.get(o)),r.manager.itemError(e),r.manager.itemEnd(e)):(t&&t(l),r.manager.itemEnd(e))});return}setTimeout(function(){t&&t(o),r.manager.itemEnd(e)},0);return}let a={};a.credentials=this.withCredentials||this.crossOrigin!=="anonymous"?"include":"same-origin",a.headers=this.requestHeader,a.priority=this.priority,a.cache=this.cache,a.signal=typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal;let c=fetch(e,a).then(function(l){return l.blob()}).then(function(l){return createImageBitmap(l,Object.assign({},r.options,{colorSpaceConversion:"none"}))}).then(function(l){return ds.add(`image-bitmap:${e}`,l),t&&t(l),r.manager.itemEnd(e),l}).catch(function(l){s&&s(l),Hd.set(c,l),ds.remove(`image-bitmap:${e}`),r.manager.itemError(e),r.manager.itemEnd(e)});ds.add(`image-bitmap:${e}`,c),r.manager.itemStart(e)}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var No=-90,Do=1,Qo=class extends jt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new bn(No,Do,e,t);s.layers=this.layers,this.add(s);let r=new bn(No,Do,e,t);r.layers=this.layers,this.add(r);let o=new bn(No,Do,e,t);o.layers=this.layers,this.add(o);let a=new bn(No,Do,e,t);a.layers=this.layers,this.add(a);let c=new bn(No,Do,e,t);c.layers=this.layers,this.add(c);let l=new bn(No,Do,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,c]=t;for(let l of t)this.remove(l);if(e===Ui)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===ko)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(n,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),n.texture.mipmapsAutoUpdate=v,e.setRenderTarget(n,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},th=class extends bn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Df="\\[\\]\\.:\\/",rb=new RegExp("["+Df+"]","g"),Of="[^"+Df+"]",ob="[^"+Df.replace("\\.","")+"]",ab=/((?:WC+[\/:])*)/.source.replace("WC",Of),lb=/(WCOD+)?/.source.replace("WCOD",ob),cb=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Of),hb=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Of),ub=new RegExp("^"+ab+lb+cb+hb+"$"),db=["material","materials","bones","map"],Jd=class{constructor(e,t,n){let s=n||Bt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Bt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(rb,"")}static parseTrackName(e){let t=ub.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);db.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let c=n(a.children);if(c)return c}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){qe("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=t.objectIndex;switch(n){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===l){l=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(l!==void 0){if(e[l]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[l]}}let o=e[s];if(o===void 0){let l=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Bt.Composite=Jd;Bt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Bt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Bt.prototype.GetterByBindingType=[Bt.prototype._getValue_direct,Bt.prototype._getValue_array,Bt.prototype._getValue_arrayElement,Bt.prototype._getValue_toArray];Bt.prototype.SetterByBindingTypeAndVersioning=[[Bt.prototype._setValue_direct,Bt.prototype._setValue_direct_setNeedsUpdate,Bt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Bt.prototype._setValue_array,Bt.prototype._setValue_array_setNeedsUpdate,Bt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Bt.prototype._setValue_arrayElement,Bt.prototype._setValue_arrayElement_setNeedsUpdate,Bt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Bt.prototype._setValue_fromArray,Bt.prototype._setValue_fromArray_setNeedsUpdate,Bt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var lR=new Float32Array(1);var Wg=new ct,$r=class{constructor(e,t,n=0,s=1/0){this.ray=new fs(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Vo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):nt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Wg.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Wg),this}intersectObject(e,t=!0,n=[]){return Qd(e,this,n,t),n.sort(Xg),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)Qd(e[s],this,n,t);return n.sort(Xg),n}};function Xg(i,e){return i.distance-e.distance}function Qd(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)Qd(r[o],e,t,!0)}}var ea=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=gt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(gt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var ef=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var gl=class extends Ki{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Uf(i,e,t,n){let s=fb(n);switch(t){case bf:return i*e;case lh:return i*e/s.components*s.byteLength;case ch:return i*e/s.components*s.byteLength;case vr:return i*e*2/s.components*s.byteLength;case hh:return i*e*2/s.components*s.byteLength;case Sf:return i*e*3/s.components*s.byteLength;case ki:return i*e*4/s.components*s.byteLength;case uh:return i*e*4/s.components*s.byteLength;case _l:case vl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case yl:case bl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case fh:case mh:return Math.max(i,16)*Math.max(e,8)/4;case dh:case ph:return Math.max(i,8)*Math.max(e,8)/2;case gh:case xh:case vh:case yh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case _h:case Sl:case bh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Sh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Mh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case wh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Th:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Eh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Ah:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Rh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Ch:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Ph:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Ih:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Lh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Nh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Dh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Oh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Uh:case Fh:case kh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Bh:case zh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Ml:case Hh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function fb(i){switch(i){case pi:case xf:return{byteLength:1,components:1};case ra:case _f:case Zi:return{byteLength:2,components:1};case oh:case ah:return{byteLength:2,components:4};case ji:case rh:case Mi:return{byteLength:4,components:1};case vf:case yf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function ex(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function mb(i){let e=new WeakMap;function t(a,c){let l=a.array,h=a.usage,u=l.byteLength,d=i.createBuffer();i.bindBuffer(c,d),i.bufferData(c,l,h),a.onUploadCallback();let f;if(l instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=i.SHORT;else if(l instanceof Uint32Array)f=i.UNSIGNED_INT;else if(l instanceof Int32Array)f=i.INT;else if(l instanceof Int8Array)f=i.BYTE;else if(l instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,c,l){let h=c.array,u=c.updateRanges;if(i.bindBuffer(l,a),u.length===0)i.bufferSubData(l,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],v=u[f];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++d,u[d]=v)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let v=u[f];i.bufferSubData(l,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=e.get(a);c&&(i.deleteBuffer(c.buffer),e.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=e.get(a);if(l===void 0)e.set(a,t(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var gb=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,xb=`#ifdef USE_ALPHAHASH
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
#endif`,_b=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,vb=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,yb=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,bb=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Sb=`#ifdef USE_AOMAP
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
#endif`,Mb=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,wb=`#ifdef USE_BATCHING
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
#endif`,Tb=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Eb=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Ab=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Rb=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Cb=`#ifdef USE_IRIDESCENCE
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
#endif`,Pb=`#ifdef USE_BUMPMAP
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
#endif`,Ib=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Lb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Nb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Db=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Ob=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Ub=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Fb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,kb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Bb=`#define PI 3.141592653589793
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
} // validated`,zb=`vec3 transformedNormal = objectNormal;
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
#endif`,Hb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Vb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Gb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Wb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Xb="gl_FragColor = linearToOutputTexel( gl_FragColor );",qb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,$b=`#ifdef USE_ENVMAP
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
#endif`,Yb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Kb=`#ifdef USE_ENVMAP
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
#endif`,jb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Zb=`#ifdef USE_ENVMAP
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
#endif`,Jb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Qb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,eS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,tS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,nS=`#ifdef USE_GRADIENTMAP
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
}`,iS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,sS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,rS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,oS=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,aS=`#ifdef USE_ENVMAP
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
#endif`,lS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,cS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,hS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,uS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,dS=`PhysicalMaterial material;
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
#endif`,fS=`uniform sampler2D dfgLUT;
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
}`,pS=`
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
#endif`,mS=`#if defined( RE_IndirectDiffuse )
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
#endif`,gS=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,xS=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,_S=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,vS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,yS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,bS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,SS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,MS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,wS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,TS=`#if defined( USE_POINTS_UV )
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
#endif`,ES=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,AS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,RS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,CS=`#if defined( USE_MORPHCOLORS )
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
#endif`,PS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,IS=`#ifdef USE_MORPHTARGETS
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
#endif`,LS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,NS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,DS=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,OS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,US=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,FS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,kS=`#ifdef USE_NORMALMAP
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
#endif`,BS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,zS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,HS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,VS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,GS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,WS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,XS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,qS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,$S=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,YS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,KS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,jS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,ZS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,JS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,QS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,eM=`float getShadowMask() {
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
}`,tM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,nM=`#ifdef USE_SKINNING
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
#endif`,iM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,sM=`#ifdef USE_SKINNING
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
#endif`,rM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,oM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,aM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,lM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,cM=`#ifdef USE_TRANSMISSION
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
#endif`,hM=`#ifdef USE_TRANSMISSION
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
#endif`,uM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,dM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,fM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,pM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,mM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,gM=`uniform sampler2D t2D;
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
}`,xM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,_M=`uniform float backgroundBlurriness;
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
}`,vM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,yM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bM=`#include <common>
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
}`,SM=`#if DEPTH_PACKING == 3200
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
}`,MM=`#define DISTANCE
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
}`,wM=`#define DISTANCE
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
}`,TM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,EM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,AM=`uniform float scale;
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
}`,RM=`uniform vec3 diffuse;
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
}`,CM=`#include <common>
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
}`,PM=`uniform vec3 diffuse;
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
}`,IM=`#define LAMBERT
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
}`,LM=`#define LAMBERT
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
}`,NM=`#define MATCAP
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
}`,DM=`#define MATCAP
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
}`,OM=`#define NORMAL
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
}`,UM=`#define NORMAL
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
}`,FM=`#define PHONG
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
}`,kM=`#define PHONG
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
}`,BM=`#define STANDARD
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
}`,zM=`#define STANDARD
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
}`,HM=`#define TOON
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
}`,VM=`#define TOON
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
}`,GM=`uniform float size;
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
}`,WM=`uniform vec3 diffuse;
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
}`,XM=`#include <common>
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
}`,qM=`uniform vec3 color;
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
}`,$M=`uniform float rotation;
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
}`,YM=`uniform vec3 diffuse;
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
}`,ft={alphahash_fragment:gb,alphahash_pars_fragment:xb,alphamap_fragment:_b,alphamap_pars_fragment:vb,alphatest_fragment:yb,alphatest_pars_fragment:bb,aomap_fragment:Sb,aomap_pars_fragment:Mb,batching_pars_vertex:wb,batching_vertex:Tb,begin_vertex:Eb,beginnormal_vertex:Ab,bsdfs:Rb,iridescence_fragment:Cb,bumpmap_pars_fragment:Pb,clipping_planes_fragment:Ib,clipping_planes_pars_fragment:Lb,clipping_planes_pars_vertex:Nb,clipping_planes_vertex:Db,color_fragment:Ob,color_pars_fragment:Ub,color_pars_vertex:Fb,color_vertex:kb,common:Bb,defaultnormal_vertex:zb,displacementmap_pars_vertex:Hb,displacementmap_vertex:Vb,emissivemap_fragment:Gb,emissivemap_pars_fragment:Wb,colorspace_fragment:Xb,colorspace_pars_fragment:qb,envmap_fragment:$b,envmap_common_pars_fragment:Yb,envmap_pars_fragment:Kb,envmap_pars_vertex:jb,envmap_physical_pars_fragment:aS,envmap_vertex:Zb,fog_vertex:Jb,fog_pars_vertex:Qb,fog_fragment:eS,fog_pars_fragment:tS,gradientmap_pars_fragment:nS,lightmap_pars_fragment:iS,lights_lambert_fragment:sS,lights_lambert_pars_fragment:rS,lights_pars_begin:oS,lights_toon_fragment:lS,lights_toon_pars_fragment:cS,lights_phong_fragment:hS,lights_phong_pars_fragment:uS,lights_physical_fragment:dS,lights_physical_pars_fragment:fS,lights_fragment_begin:pS,lights_fragment_maps:mS,lights_fragment_end:gS,lightprobes_pars_fragment:xS,logdepthbuf_fragment:_S,logdepthbuf_pars_fragment:vS,logdepthbuf_pars_vertex:yS,logdepthbuf_vertex:bS,map_fragment:SS,map_pars_fragment:MS,map_particle_fragment:wS,map_particle_pars_fragment:TS,metalnessmap_fragment:ES,metalnessmap_pars_fragment:AS,morphinstance_vertex:RS,morphcolor_vertex:CS,morphnormal_vertex:PS,morphtarget_pars_vertex:IS,morphtarget_vertex:LS,normal_fragment_begin:NS,normal_fragment_maps:DS,normal_pars_fragment:OS,normal_pars_vertex:US,normal_vertex:FS,normalmap_pars_fragment:kS,clearcoat_normal_fragment_begin:BS,clearcoat_normal_fragment_maps:zS,clearcoat_pars_fragment:HS,iridescence_pars_fragment:VS,opaque_fragment:GS,packing:WS,premultiplied_alpha_fragment:XS,project_vertex:qS,dithering_fragment:$S,dithering_pars_fragment:YS,roughnessmap_fragment:KS,roughnessmap_pars_fragment:jS,shadowmap_pars_fragment:ZS,shadowmap_pars_vertex:JS,shadowmap_vertex:QS,shadowmask_pars_fragment:eM,skinbase_vertex:tM,skinning_pars_vertex:nM,skinning_vertex:iM,skinnormal_vertex:sM,specularmap_fragment:rM,specularmap_pars_fragment:oM,tonemapping_fragment:aM,tonemapping_pars_fragment:lM,transmission_fragment:cM,transmission_pars_fragment:hM,uv_pars_fragment:uM,uv_pars_vertex:dM,uv_vertex:fM,worldpos_vertex:pM,background_vert:mM,background_frag:gM,backgroundCube_vert:xM,backgroundCube_frag:_M,cube_vert:vM,cube_frag:yM,depth_vert:bM,depth_frag:SM,distance_vert:MM,distance_frag:wM,equirect_vert:TM,equirect_frag:EM,linedashed_vert:AM,linedashed_frag:RM,meshbasic_vert:CM,meshbasic_frag:PM,meshlambert_vert:IM,meshlambert_frag:LM,meshmatcap_vert:NM,meshmatcap_frag:DM,meshnormal_vert:OM,meshnormal_frag:UM,meshphong_vert:FM,meshphong_frag:kM,meshphysical_vert:BM,meshphysical_frag:zM,meshtoon_vert:HM,meshtoon_frag:VM,points_vert:GM,points_frag:WM,shadow_vert:XM,shadow_frag:qM,sprite_vert:$M,sprite_frag:YM},Oe={common:{diffuse:{value:new Ke(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new je(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ke(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ke(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new Ke(16777215)},opacity:{value:1},center:{value:new je(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},bs={basic:{uniforms:Yn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Yn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,Oe.lights,{emissive:{value:new Ke(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Yn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,Oe.lights,{emissive:{value:new Ke(0)},specular:{value:new Ke(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Yn([Oe.common,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.roughnessmap,Oe.metalnessmap,Oe.fog,Oe.lights,{emissive:{value:new Ke(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Yn([Oe.common,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.gradientmap,Oe.fog,Oe.lights,{emissive:{value:new Ke(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Yn([Oe.common,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Yn([Oe.points,Oe.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Yn([Oe.common,Oe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Yn([Oe.common,Oe.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Yn([Oe.common,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Yn([Oe.sprite,Oe.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:Yn([Oe.common,Oe.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:Yn([Oe.lights,Oe.fog,{color:{value:new Ke(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};bs.physical={uniforms:Yn([bs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new je(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new st},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new Ke(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new je},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new Ke(0)},specularColor:{value:new Ke(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new je},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var Wh={r:0,b:0,g:0},KM=new ct,tx=new st;tx.set(-1,0,0,0,1,0,0,0,1);function jM(i,e,t,n,s,r){let o=new Ke(0),a=s===!0?0:1,c,l,h=null,u=0,d=null;function f(y){let M=y.isScene===!0?y.background:null;if(M&&M.isTexture){let b=y.backgroundBlurriness>0;M=e.get(M,b)}return M}function p(y){let M=!1,b=f(y);b===null?g(o,a):b&&b.isColor&&(g(b,1),M=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(y,M){let b=f(M);b&&b.isCubeTexture?(l===void 0&&(l=new Zt(new jo(1,1,1),new ps({name:"BackgroundCubeMaterial",uniforms:Qr(bs.backgroundCube.uniforms),vertexShader:bs.backgroundCube.vertexShader,fragmentShader:bs.backgroundCube.fragmentShader,side:ri,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(C,A,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=b,l.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(KM.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(tx),l.material.toneMapped=mt.getTransfer(b.colorSpace)!==Ct,(h!==b||u!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null)):b&&b.isTexture&&(c===void 0&&(c=new Zt(new ol(2,2),new ps({name:"BackgroundMaterial",uniforms:Qr(bs.background.uniforms),vertexShader:bs.background.vertexShader,fragmentShader:bs.background.fragmentShader,side:xs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=b,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.toneMapped=mt.getTransfer(b.colorSpace)!==Ct,b.matrixAutoUpdate===!0&&b.updateMatrix(),c.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null))}function g(y,M){y.getRGB(Wh,Nf(i)),t.buffers.color.setClear(Wh.r,Wh.g,Wh.b,M,r)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,M=1){o.set(y),a=M,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:p,addToRenderList:v,dispose:m}}function ZM(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(L,W,X,O,H){let Y=!1,B=u(L,O,X,W);r!==B&&(r=B,l(r.object)),Y=f(L,O,X,H),Y&&p(L,O,X,H),H!==null&&e.update(H,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(L,W,X,O),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function c(){return i.createVertexArray()}function l(L){return i.bindVertexArray(L)}function h(L){return i.deleteVertexArray(L)}function u(L,W,X,O){let H=O.wireframe===!0,Y=n[W.id];Y===void 0&&(Y={},n[W.id]=Y);let B=L.isInstancedMesh===!0?L.id:0,ce=Y[B];ce===void 0&&(ce={},Y[B]=ce);let Z=ce[X.id];Z===void 0&&(Z={},ce[X.id]=Z);let ee=Z[H];return ee===void 0&&(ee=d(c()),Z[H]=ee),ee}function d(L){let W=[],X=[],O=[];for(let H=0;H<t;H++)W[H]=0,X[H]=0,O[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:W,enabledAttributes:X,attributeDivisors:O,object:L,attributes:{},index:null}}function f(L,W,X,O){let H=r.attributes,Y=W.attributes,B=0,ce=X.getAttributes();for(let Z in ce)if(ce[Z].location>=0){let se=H[Z],fe=Y[Z];if(fe===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(fe=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(fe=L.instanceColor)),se===void 0||se.attribute!==fe||fe&&se.data!==fe.data)return!0;B++}return r.attributesNum!==B||r.index!==O}function p(L,W,X,O){let H={},Y=W.attributes,B=0,ce=X.getAttributes();for(let Z in ce)if(ce[Z].location>=0){let se=Y[Z];se===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(se=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(se=L.instanceColor));let fe={};fe.attribute=se,se&&se.data&&(fe.data=se.data),H[Z]=fe,B++}r.attributes=H,r.attributesNum=B,r.index=O}function v(){let L=r.newAttributes;for(let W=0,X=L.length;W<X;W++)L[W]=0}function g(L){m(L,0)}function m(L,W){let X=r.newAttributes,O=r.enabledAttributes,H=r.attributeDivisors;X[L]=1,O[L]===0&&(i.enableVertexAttribArray(L),O[L]=1),H[L]!==W&&(i.vertexAttribDivisor(L,W),H[L]=W)}function y(){let L=r.newAttributes,W=r.enabledAttributes;for(let X=0,O=W.length;X<O;X++)W[X]!==L[X]&&(i.disableVertexAttribArray(X),W[X]=0)}function M(L,W,X,O,H,Y,B){B===!0?i.vertexAttribIPointer(L,W,X,H,Y):i.vertexAttribPointer(L,W,X,O,H,Y)}function b(L,W,X,O){v();let H=O.attributes,Y=X.getAttributes(),B=W.defaultAttributeValues;for(let ce in Y){let Z=Y[ce];if(Z.location>=0){let ee=H[ce];if(ee===void 0&&(ce==="instanceMatrix"&&L.instanceMatrix&&(ee=L.instanceMatrix),ce==="instanceColor"&&L.instanceColor&&(ee=L.instanceColor)),ee!==void 0){let se=ee.normalized,fe=ee.itemSize,de=e.get(ee);if(de===void 0)continue;let te=de.buffer,ge=de.type,ve=de.bytesPerElement,Ce=ge===i.INT||ge===i.UNSIGNED_INT||ee.gpuType===rh;if(ee.isInterleavedBufferAttribute){let Me=ee.data,$e=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,at=ee.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let We=0;We<Z.locationSize;We++)m(Z.location+We,Me.meshPerAttribute);L.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let We=0;We<Z.locationSize;We++)g(Z.location+We);i.bindBuffer(i.ARRAY_BUFFER,te);for(let We=0;We<Z.locationSize;We++)M(Z.location+We,fe/Z.locationSize,ge,se,$e*ve,(at+fe/Z.locationSize*We)*ve,Ce)}else{if(ee.isInstancedBufferAttribute){for(let Me=0;Me<Z.locationSize;Me++)m(Z.location+Me,ee.meshPerAttribute);L.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let Me=0;Me<Z.locationSize;Me++)g(Z.location+Me);i.bindBuffer(i.ARRAY_BUFFER,te);for(let Me=0;Me<Z.locationSize;Me++)M(Z.location+Me,fe/Z.locationSize,ge,se,fe*ve,fe/Z.locationSize*Me*ve,Ce)}}else if(B!==void 0){let se=B[ce];if(se!==void 0)switch(se.length){case 2:i.vertexAttrib2fv(Z.location,se);break;case 3:i.vertexAttrib3fv(Z.location,se);break;case 4:i.vertexAttrib4fv(Z.location,se);break;default:i.vertexAttrib1fv(Z.location,se)}}}}y()}function C(){k();for(let L in n){let W=n[L];for(let X in W){let O=W[X];for(let H in O){let Y=O[H];for(let B in Y)h(Y[B].object),delete Y[B];delete O[H]}}delete n[L]}}function A(L){if(n[L.id]===void 0)return;let W=n[L.id];for(let X in W){let O=W[X];for(let H in O){let Y=O[H];for(let B in Y)h(Y[B].object),delete Y[B];delete O[H]}}delete n[L.id]}function x(L){for(let W in n){let X=n[W];for(let O in X){let H=X[O];if(H[L.id]===void 0)continue;let Y=H[L.id];for(let B in Y)h(Y[B].object),delete Y[B];delete H[L.id]}}}function E(L){for(let W in n){let X=n[W],O=L.isInstancedMesh===!0?L.id:0,H=X[O];if(H!==void 0){for(let Y in H){let B=H[Y];for(let ce in B)h(B[ce].object),delete B[ce];delete H[Y]}delete X[O],Object.keys(X).length===0&&delete n[W]}}}function k(){D(),o=!0,r!==s&&(r=s,l(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:D,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:E,releaseStatesOfProgram:x,initAttributes:v,enableAttribute:g,disableUnusedAttributes:y}}function JM(i,e,t){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),t.update(l,n,1)}function o(c,l,h){h!==0&&(i.drawArraysInstanced(n,c,l,h),t.update(l,n,h))}function a(c,l,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let d=0;for(let f=0;f<h;f++)d+=l[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function QM(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==ki&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let E=x===Zi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==pi&&x!==Mi&&!E&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp",h=c(l);h!==l&&(qe("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&qe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&qe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:y,maxVaryings:M,maxFragmentUniforms:b,maxSamples:C,samples:A}}function ew(i){let e=this,t=null,n=0,s=!1,r=!1,o=new zn,a=new st,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,v=u.clipIntersection,g=u.clipShadows,m=i.get(u);if(!s||p===null||p.length===0||r&&!g)r?h(null):l();else{let y=r?0:n,M=y*4,b=m.clippingState||null;c.value=b,b=h(p,d,M,f);for(let C=0;C!==M;++C)b[C]=t[C];m.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,p){let v=u!==null?u.length:0,g=null;if(v!==0){if(g=c.value,p!==!0||g===null){let m=f+v*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<m)&&(g=new Float32Array(m));for(let M=0,b=f;M!==v;++M,b+=4)o.copy(u[M]).applyMatrix4(y,a),o.normal.toArray(g,b),g[b+3]=o.constant}c.value=g,c.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}var Al=class extends Si{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new il(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new jo(5,5,5),r=new ps({name:"CubemapFromEquirect",uniforms:Qr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ri,blending:Yr});r.uniforms.tEquirect.value=t;let o=new Zt(s,r),a=t.minFilter;return t.minFilter===Fi&&(t.minFilter=Sn),new Qo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},N0=256,tw=3,nw=20,nx=256,ix=16,iw=3,sw=new V,rw=new Ke,qh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Qo(1,10,null),this._boxMesh=new Zt(new jo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=sw}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=c.autoClear,d=c.autoClearColor,f=c.autoClearDepth,p=c.autoClearStencil,v=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,v===null&&(e.background=c.getClearColor(rw));let g=new Qo(n,s,h);return g.position.copy(a),g.update(c,e),c.autoClear=u,c.autoClearColor=d,c.autoClearDepth=f,c.autoClearStencil=p,e.background=v,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,t)),this._applyPMREM(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=U0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=O0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(N0,Pf(e))}_fromTexture(e,t){e.mapping===jr||e.mapping===ia?this._setSize(e.image.length===0?N0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=D0(e,!1,!1),n=Math.log2(e)-tw;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=D0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===jr||e.mapping===ia?(this._cubemapMaterial===null&&(this._cubemapMaterial=U0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=O0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=ow(),this._integrationMaterial=aw());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/ix);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-iw)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let c=a>0?Math.log2(t)+.5*Math.log2(6/(nx*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=lw());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function D0(i,e,t){return new Al(i,{minFilter:Fi,generateMipmaps:e,type:Zi,colorSpace:ii,depthBuffer:t})}function Rl(i,e,t){return new ps({name:i,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:ri,blending:Yr,depthTest:!1,depthWrite:!1})}function ow(){return Rl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${nx}u

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
	`)}function aw(){return Rl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:ix}},`

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
	`)}function lw(){return Rl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${nw}
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
	`)}function O0(){return Rl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function U0(){return Rl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function cw(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===nh||f===ih)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let v=new Al(p.height);return v.fromEquirectangularTexture(i,d),e.set(d,v),d.addEventListener("dispose",l),a(v.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===nh||f===ih,v=f===jr||f===ia;if(p||v){let g=t.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new qh(i)),g=p?n.fromEquirectangular(d,g):n.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let y=d.image;return p&&y&&y.height>0||v&&y&&c(y)?(n===null&&(n=new qh(i)),g=p?n.fromEquirectangular(d):n.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",h),g.texture):null}}}return d}function a(d,f){return f===nh?d.mapping=jr:f===ih&&(d.mapping=ia),d}function c(d){let f=0,p=6;for(let v=0;v<p;v++)d[v]!==void 0&&f++;return f===p}function l(d){let f=d.target;f.removeEventListener("dispose",l);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function hw(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Br("WebGLRenderer: "+n+" extension not supported."),s}}}function uw(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){c(p.target)}function c(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let v=r.get(p);v&&(e.remove(v),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function l(p,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function h(p){let v=p.attributes;for(let g in v)e.update(v[g],i.ARRAY_BUFFER)}function u(p){let v=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let y=v!==null?v.array.length:g.array.length/3-1,M=g.count>=65535?ja:Ka,b=new M(Math.ceil(y/3)*6,1),C=b.array;if(v!==null){let x=v.array;m=v.version;for(let E=0,k=0;E<y;E+=3){let D=x[E+0],L=x[E+1],W=x[E+2];C[k++]=D,C[k++]=L,C[k++]=L,C[k++]=W,C[k++]=W,C[k++]=D}}else{m=g.version;for(let x=0,E=0;x<y;x+=3){let k=x+0,D=x+1,L=x+2;C[E++]=k,C[E++]=D,C[E++]=D,C[E++]=L,C[E++]=L,C[E++]=k}}b.version=m;let A=r.get(p);A&&e.remove(A),r.set(p,b)}function d(p){let v=r.get(p);if(v){let g=p.index;g!==null&&v.version<g.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let v=s[p].deref();v!==void 0&&c(v)}}return{get:l,update:h,getWireframeAttribute:d,dispose:f}}function dw(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function c(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function l(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let v=0;for(let g=0;g<f;g++)v+=d[g];t.update(v,n,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function fw(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:nt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function pw(i,e,t){let n=new WeakMap,s=new Dt;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let k=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",k)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],M=0;f===!0&&(M=1),p===!0&&(M=2),v===!0&&(M=3);let b=a.attributes.position.count*M,C=1;b>e.maxTextureSize&&(C=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let A=new Float32Array(b*C*4*u),x=new $a(A,b,C,u);x.type=Mi,x.needsUpdate=!0;let E=M*4;for(let D=0;D<u;D++){let L=g[D],W=m[D],X=y[D],O=b*C*4*D;for(let H=0;H<L.count;H++){let Y=H*E;f===!0&&(s.fromBufferAttribute(L,H),A[O+Y+0]=s.x,A[O+Y+1]=s.y,A[O+Y+2]=s.z,A[O+Y+3]=0),p===!0&&(s.fromBufferAttribute(W,H),A[O+Y+4]=s.x,A[O+Y+5]=s.y,A[O+Y+6]=s.z,A[O+Y+7]=0),v===!0&&(s.fromBufferAttribute(X,H),A[O+Y+8]=s.x,A[O+Y+9]=s.y,A[O+Y+10]=s.z,A[O+Y+11]=X.itemSize===4?s.w:1)}}d={count:u,texture:x,size:new je(b,C)},n.set(a,d),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<l.length;v++)f+=l[v];let p=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(i,"morphTargetBaseInfluence",p),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),c.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function mw(i,e,t,n,s){let r=new WeakMap;function o(l){let h=s.render.frame,u=l.geometry,d=e.get(l,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var gw={[cf]:"LINEAR_TONE_MAPPING",[hf]:"REINHARD_TONE_MAPPING",[uf]:"CINEON_TONE_MAPPING",[df]:"ACES_FILMIC_TONE_MAPPING",[pf]:"AGX_TONE_MAPPING",[mf]:"NEUTRAL_TONE_MAPPING",[ff]:"CUSTOM_TONE_MAPPING"};function xw(i,e,t,n,s,r){let o=new Si(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new Vn;h.setAttribute("position",new Un([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Un([0,2,0,0,2,0],2));let u=new Xc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Zt(h,u),f=new Xr(-1,1,1,-1,0,1),p=null,v=null,g=!1,m,y=null,M=[],b=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),c!==null&&c.setSize(C,A);for(let x=0;x<M.length;x++){let E=M[x];E.setSize&&E.setSize(C,A)}},this.setEffects=function(C){M=C,b=M.length>0&&M[0].isRenderPass===!0;let A=o.width,x=o.height;M.length>0&&a===null&&(a=new Si(A,x,{type:Zi,depthBuffer:!1,stencilBuffer:!1}),c=new Si(A,x,{type:Zi,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&M.some(k=>k.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&l===null&&(l=new zs(A,x),r===!0&&(l.format=$s,l.type=Jr)),o.dispose(),o.depthTexture=E?l:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let k=0;k<M.length;k++){let D=M[k];D.setSize&&D.setSize(A,x),E&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(l)}},this.begin=function(C,A){if(g||C.toneMapping===_s&&M.length===0)return!1;if(y=A,A!==null){let x=A.width,E=A.height;(o.width!==x||o.height!==E)&&this.setSize(x,E)}return b===!1&&C.setRenderTarget(o),m=C.toneMapping,C.toneMapping=_s,!0},this.hasRenderPass=function(){return b},this.end=function(C,A){C.toneMapping=m,g=!0;let x=o,E=a;for(let k=0;k<M.length;k++){let D=M[k];D.enabled!==!1&&(D.render(C,E,x,A),D.needsSwap!==!1&&(x=E,E=E===a?c:a))}if(p!==C.outputColorSpace||v!==C.toneMapping){p=C.outputColorSpace,v=C.toneMapping,u.defines={},mt.getTransfer(p)===Ct&&(u.defines.SRGB_TRANSFER="");let k=gw[v];k&&(u.defines[k]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(y),C.render(d,f),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),u.dispose()}}var sx=new kn,rx=new zs(1,1),ox=new sl(1),ax=new $a,lx=new Hc,cx=new il,F0=[],k0=[],B0=new Float32Array(16),z0=new Float32Array(9),H0=new Float32Array(4);function ca(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=F0[s];if(r===void 0&&(r=new Float32Array(s),F0[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Mn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function wn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Yh(i,e){let t=k0[e];t===void 0&&(t=new Int32Array(e),k0[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function _w(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function vw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;i.uniform2fv(this.addr,e),wn(t,e)}}function yw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Mn(t,e))return;i.uniform3fv(this.addr,e),wn(t,e)}}function bw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;i.uniform4fv(this.addr,e),wn(t,e)}}function Sw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Mn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),wn(t,e)}else{if(Mn(t,n))return;H0.set(n),i.uniformMatrix2fv(this.addr,!1,H0),wn(t,n)}}function Mw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Mn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),wn(t,e)}else{if(Mn(t,n))return;z0.set(n),i.uniformMatrix3fv(this.addr,!1,z0),wn(t,n)}}function ww(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Mn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),wn(t,e)}else{if(Mn(t,n))return;B0.set(n),i.uniformMatrix4fv(this.addr,!1,B0),wn(t,n)}}function Tw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function Ew(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;i.uniform2iv(this.addr,e),wn(t,e)}}function Aw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mn(t,e))return;i.uniform3iv(this.addr,e),wn(t,e)}}function Rw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;i.uniform4iv(this.addr,e),wn(t,e)}}function Cw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function Pw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;i.uniform2uiv(this.addr,e),wn(t,e)}}function Iw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mn(t,e))return;i.uniform3uiv(this.addr,e),wn(t,e)}}function Lw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;i.uniform4uiv(this.addr,e),wn(t,e)}}function Kh(i){return i.version===0&&(i.compareFunction=Ef,i.needsUpdate=!0),i}function Nw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Kh(rx):r=sx,t.setTexture2D(e||r,s)}function Dw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||lx,s)}function Ow(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Kh(ox):r=cx,t.setTextureCube(e||r,s)}function Uw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||ax,s)}function Fw(i){switch(i){case 5126:return _w;case 35664:return vw;case 35665:return yw;case 35666:return bw;case 35674:return Sw;case 35675:return Mw;case 35676:return ww;case 5124:case 35670:return Tw;case 35667:case 35671:return Ew;case 35668:case 35672:return Aw;case 35669:case 35673:return Rw;case 5125:return Cw;case 36294:return Pw;case 36295:return Iw;case 36296:return Lw;case 35678:case 36198:case 36298:case 36306:case 35682:return Nw;case 35679:case 36299:case 36307:return Dw;case 35680:case 36300:case 36308:case 36293:return Ow;case 36289:case 36303:case 36311:case 36292:return Uw}}function kw(i,e){i.uniform1fv(this.addr,e)}function Bw(i,e){let t=ca(e,this.size,2);i.uniform2fv(this.addr,t)}function zw(i,e){let t=ca(e,this.size,3);i.uniform3fv(this.addr,t)}function Hw(i,e){let t=ca(e,this.size,4);i.uniform4fv(this.addr,t)}function Vw(i,e){let t=ca(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Gw(i,e){let t=ca(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function Ww(i,e){let t=ca(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function Xw(i,e){i.uniform1iv(this.addr,e)}function qw(i,e){i.uniform2iv(this.addr,e)}function $w(i,e){i.uniform3iv(this.addr,e)}function Yw(i,e){i.uniform4iv(this.addr,e)}function Kw(i,e){i.uniform1uiv(this.addr,e)}function jw(i,e){i.uniform2uiv(this.addr,e)}function Zw(i,e){i.uniform3uiv(this.addr,e)}function Jw(i,e){i.uniform4uiv(this.addr,e)}function Qw(i,e,t){let n=this.cache,s=e.length,r=Yh(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Kh(rx):o=sx;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function eT(i,e,t){let n=this.cache,s=e.length,r=Yh(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||lx,r[o])}function tT(i,e,t){let n=this.cache,s=e.length,r=Yh(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Kh(ox):o=cx;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function nT(i,e,t){let n=this.cache,s=e.length,r=Yh(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||ax,r[o])}function iT(i){switch(i){case 5126:return kw;case 35664:return Bw;case 35665:return zw;case 35666:return Hw;case 35674:return Vw;case 35675:return Gw;case 35676:return Ww;case 5124:case 35670:return Xw;case 35667:case 35671:return qw;case 35668:case 35672:return $w;case 35669:case 35673:return Yw;case 5125:return Kw;case 36294:return jw;case 36295:return Zw;case 36296:return Jw;case 35678:case 36198:case 36298:case 36306:case 35682:return Qw;case 35679:case 36299:case 36307:return eT;case 35680:case 36300:case 36308:case 36293:return tT;case 36289:case 36303:case 36311:case 36292:return nT}}var Bf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=Fw(t.type)}},zf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=iT(t.type)}},Hf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Ff=/(\w+)(\])?(\[|\.)?/g;function V0(i,e){i.seq.push(e),i.map[e.id]=e}function sT(i,e,t){let n=i.name,s=n.length;for(Ff.lastIndex=0;;){let r=Ff.exec(n),o=Ff.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){V0(t,l===void 0?new Bf(a,i,e):new zf(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Hf(a),V0(t,u)),t=u}}}var la=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),c=e.getUniformLocation(t,a.name);sT(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(e,c.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function G0(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var rT=37297,oT=0;function aT(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var W0=new st;function lT(i){mt._getMatrix(W0,mt.workingColorSpace,i);let e=`mat3( ${W0.elements.map(t=>t.toFixed(4))} )`;switch(mt.getTransfer(i)){case Xa:return[e,"LinearTransferOETF"];case Ct:return[e,"sRGBTransferOETF"];default:return qe("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function X0(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+aT(i.getShaderSource(e),a)}else return r}function cT(i,e){let t=lT(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var hT={[cf]:"Linear",[hf]:"Reinhard",[uf]:"Cineon",[df]:"ACESFilmic",[pf]:"AgX",[mf]:"Neutral",[ff]:"Custom"};function uT(i,e){let t=hT[e];return t===void 0?(qe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Xh=new V;function dT(){mt.getLuminanceCoefficients(Xh);let i=Xh.x.toFixed(4),e=Xh.y.toFixed(4),t=Xh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function fT(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(El).join(`
`)}function pT(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function mT(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function El(i){return i!==""}function q0(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function $0(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var gT=/^[ \t]*#include +<([\w\d./]+)>/gm;function Vf(i){return i.replace(gT,xT)}function xT(i,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Vf(t)}var _T=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Y0(i){return i.replace(_T,vT)}function vT(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function K0(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var yT={[xl]:"SHADOWMAP_TYPE_PCF",[ta]:"SHADOWMAP_TYPE_VSM"};function bT(i){return yT[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var ST={[ia]:"ENVMAP_MODE_REFRACTION"};function MT(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":ST[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var wT={[lf]:"ENVMAP_BLENDING_MULTIPLY",[f0]:"ENVMAP_BLENDING_MIX",[p0]:"ENVMAP_BLENDING_ADD"};function TT(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":wT[i.combine]||"ENVMAP_BLENDING_NONE"}function ET(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,c=bT(t),l=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=MT(t),u=TT(t),d=fT(t),f=pT(r),p=s.createProgram(),v,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(El).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(El).join(`
`),g.length>0&&(g+=`
`)):(v=[K0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(El).join(`
`),g=[K0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==_s?"#define TONE_MAPPING":"",t.toneMapping!==_s?ft.tonemapping_pars_fragment:"",t.toneMapping!==_s?uT("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,cT("linearToOutputTexel",t.outputColorSpace),dT(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(El).join(`
`)),o=Vf(o),o=q0(o,t),o=$0(o,t),a=Vf(a),a=q0(a,t),a=$0(a,t),o=Y0(o),a=Y0(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,v=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",t.glslVersion===Rf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Rf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=m+v+o,M=m+g+a,b=G0(s,s.VERTEX_SHADER,y),C=G0(s,s.FRAGMENT_SHADER,M);s.attachShader(p,b),s.attachShader(p,C),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function A(D){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",W=s.getShaderInfoLog(b)||"",X=s.getShaderInfoLog(C)||"",O=L.trim(),H=W.trim(),Y=X.trim(),B=!0,ce=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(B=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,b,C);else{let Z=X0(s,b,"vertex"),ee=X0(s,C,"fragment");nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+O+`
`+Z+`
`+ee)}else O!==""?qe("WebGLProgram: Program Info Log:",O):(H===""||Y==="")&&(ce=!1);ce&&(D.diagnostics={runnable:B,programLog:O,vertexShader:{log:H,prefix:v},fragmentShader:{log:Y,prefix:g}})}s.deleteShader(b),s.deleteShader(C),x=new la(s,p),E=mT(s,p)}let x;this.getUniforms=function(){return x===void 0&&A(this),x};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let k=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(p,rT)),k},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=oT++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=C,this}var AT=0,Gf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Wf(e),t.set(e,n)),n}},Wf=class{constructor(e){this.id=AT++,this.code=e,this.usedTimes=0}};function RT(i){return i===vr||i===Sl||i===Ml}function CT(i,e,t,n,s,r){let o=new Vo,a=new Gf,c=new Set,l=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return c.add(x),x===0?"uv":`uv${x}`}function p(x,E,k,D,L,W){let X=D.fog,O=L.geometry,H=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?D.environment:null,Y=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,B=e.get(x.envMap||H,Y),ce=d[x.type],Z=n.precision;x.precision!==null&&(Z=n.getMaxPrecision(x.precision),Z!==x.precision&&qe("WebGLProgram.getParameters:",x.precision,"not supported, using",Z,"instead."));let ee=O.morphAttributes.position||O.morphAttributes.normal||O.morphAttributes.color,se=ee!==void 0?ee.length:0,fe=0;O.morphAttributes.position!==void 0&&(fe=1),O.morphAttributes.normal!==void 0&&(fe=2),O.morphAttributes.color!==void 0&&(fe=3);let de,te,ge,ve;if(ce){let Pe=bs[ce];de=Pe.vertexShader,te=Pe.fragmentShader}else{de=x.vertexShader,te=x.fragmentShader;let Pe=a.getVertexShaderStage(x),ht=a.getFragmentShaderStage(x);a.update(x,Pe,ht),ge=Pe.id,ve=ht.id}let Ce=i.getRenderTarget(),Me=i.state.buffers.depth.getReversed(),$e=L.isInstancedMesh===!0,at=L.isBatchedMesh===!0,We=!!x.map,pt=!!x.matcap,ut=!!B,rt=ut&&B.isPMREMTexture===!0,Yt=!!x.aoMap,Vt=!!x.lightMap,hn=!!x.bumpMap&&x.wireframe===!1,Ot=!!x.normalMap,Pn=!!x.displacementMap,Mt=!!x.emissiveMap,_n=!!x.metalnessMap,en=!!x.roughnessMap,un=x.anisotropy>0,F=x.clearcoat>0,Ie=x.diffuseRoughness>0,Je=x.dispersion>0,lt=x.retroreflectivity>0,we=x.iridescence>0,kt=x.sheen>0,Ge=x.transmission>0,Ze=un&&!!x.anisotropyMap,P=F&&!!x.clearcoatMap,S=F&&!!x.clearcoatNormalMap,$=F&&!!x.clearcoatRoughnessMap,ue=Ie&&!!x.diffuseRoughnessMap,ae=we&&!!x.iridescenceMap,_e=we&&!!x.iridescenceThicknessMap,ye=kt&&!!x.sheenColorMap,ne=kt&&!!x.sheenRoughnessMap,re=!!x.specularMap,me=!!x.specularColorMap,U=!!x.specularIntensityMap,oe=Ge&&!!x.transmissionMap,ie=Ge&&!!x.thicknessMap,Te=!!x.gradientMap,xe=!!x.alphaMap,Se=x.alphaTest>0,Xe=!!x.alphaHash,et=!!x.extensions,he=_s;x.toneMapped&&(Ce===null||Ce.isXRRenderTarget===!0)&&(he=i.toneMapping);let ze=rt?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,tt={shaderID:ce,shaderType:x.type,shaderName:x.name,vertexShader:de,fragmentShader:te,defines:x.defines,customVertexShaderID:ge,customFragmentShaderID:ve,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Z,batching:at,batchingColor:at&&L._colorsTexture!==null,instancing:$e,instancingColor:$e&&L.instanceColor!==null,instancingMorph:$e&&L.morphTexture!==null,outputColorSpace:Ce===null?i.outputColorSpace:Ce.isXRRenderTarget===!0?Ce.texture.colorSpace:mt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:We,matcap:pt,envMap:ut,envMapMode:ut&&B.mapping,envMapPMREM:rt,envMapMaxLod:rt?ze.length-1:null,envMapSize:rt?ze[0].width:null,aoMap:Yt,lightMap:Vt,bumpMap:hn,normalMap:Ot,displacementMap:Pn,emissiveMap:Mt,normalMapObjectSpace:Ot&&x.normalMapType===_0,normalMapTangentSpace:Ot&&x.normalMapType===Vh,packedNormalMap:Ot&&x.normalMapType===Vh&&RT(x.normalMap.format),metalnessMap:_n,roughnessMap:en,anisotropy:un,anisotropyMap:Ze,clearcoat:F,clearcoatMap:P,clearcoatNormalMap:S,clearcoatRoughnessMap:$,diffuseRoughness:Ie,diffuseRoughnessMap:ue,dispersion:Je,retroreflection:lt,iridescence:we,iridescenceMap:ae,iridescenceThicknessMap:_e,sheen:kt,sheenColorMap:ye,sheenRoughnessMap:ne,specularMap:re,specularColorMap:me,specularIntensityMap:U,transmission:Ge,transmissionMap:oe,thicknessMap:ie,gradientMap:Te,opaque:x.transparent===!1&&x.blending===na&&x.alphaToCoverage===!1,alphaMap:xe,alphaTest:Se,alphaHash:Xe,combine:x.combine,mapUv:We&&f(x.map.channel),aoMapUv:Yt&&f(x.aoMap.channel),lightMapUv:Vt&&f(x.lightMap.channel),bumpMapUv:hn&&f(x.bumpMap.channel),normalMapUv:Ot&&f(x.normalMap.channel),displacementMapUv:Pn&&f(x.displacementMap.channel),emissiveMapUv:Mt&&f(x.emissiveMap.channel),metalnessMapUv:_n&&f(x.metalnessMap.channel),roughnessMapUv:en&&f(x.roughnessMap.channel),anisotropyMapUv:Ze&&f(x.anisotropyMap.channel),clearcoatMapUv:P&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:ne&&f(x.sheenRoughnessMap.channel),specularMapUv:re&&f(x.specularMap.channel),specularColorMapUv:me&&f(x.specularColorMap.channel),specularIntensityMapUv:U&&f(x.specularIntensityMap.channel),transmissionMapUv:oe&&f(x.transmissionMap.channel),thicknessMapUv:ie&&f(x.thicknessMap.channel),alphaMapUv:xe&&f(x.alphaMap.channel),vertexTangents:!!O.attributes.tangent&&(Ot||un),vertexNormals:!!O.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!O.attributes.color&&O.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!O.attributes.uv&&(We||xe),fog:!!X,useFog:x.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||O.attributes.normal===void 0&&Ot===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Me,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:O.attributes.position!==void 0,morphTargets:O.morphAttributes.position!==void 0,morphNormals:O.morphAttributes.normal!==void 0,morphColors:O.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:fe,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:W.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&k.length>0,shadowMapType:i.shadowMap.type,toneMapping:he,decodeVideoTexture:We&&x.map.isVideoTexture===!0&&mt.getTransfer(x.map.colorSpace)===Ct,decodeVideoTextureEmissive:Mt&&x.emissiveMap.isVideoTexture===!0&&mt.getTransfer(x.emissiveMap.colorSpace)===Ct,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===fi,flipSided:x.side===ri,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:et&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&x.extensions.multiDraw===!0||at)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return tt.vertexUv1s=c.has(1),tt.vertexUv2s=c.has(2),tt.vertexUv3s=c.has(3),c.clear(),tt}function v(x){let E=[];if(x.shaderID?E.push(x.shaderID):(E.push(x.customVertexShaderID),E.push(x.customFragmentShaderID)),x.defines!==void 0)for(let k in x.defines)E.push(k),E.push(x.defines[k]);return x.isRawShaderMaterial===!1&&(g(E,x),m(E,x),E.push(i.outputColorSpace)),E.push(x.customProgramCacheKey),E.join()}function g(x,E){x.push(E.precision),x.push(E.outputColorSpace),x.push(E.envMapMode),x.push(E.envMapPMREM),x.push(E.envMapMaxLod),x.push(E.envMapSize),x.push(E.mapUv),x.push(E.alphaMapUv),x.push(E.lightMapUv),x.push(E.aoMapUv),x.push(E.bumpMapUv),x.push(E.normalMapUv),x.push(E.displacementMapUv),x.push(E.emissiveMapUv),x.push(E.metalnessMapUv),x.push(E.roughnessMapUv),x.push(E.anisotropyMapUv),x.push(E.clearcoatMapUv),x.push(E.clearcoatNormalMapUv),x.push(E.clearcoatRoughnessMapUv),x.push(E.diffuseRoughnessMapUv),x.push(E.iridescenceMapUv),x.push(E.iridescenceThicknessMapUv),x.push(E.sheenColorMapUv),x.push(E.sheenRoughnessMapUv),x.push(E.specularMapUv),x.push(E.specularColorMapUv),x.push(E.specularIntensityMapUv),x.push(E.transmissionMapUv),x.push(E.thicknessMapUv),x.push(E.combine),x.push(E.fogExp2),x.push(E.sizeAttenuation),x.push(E.morphTargetsCount),x.push(E.numSunLights),x.push(E.numDirLights),x.push(E.numPointLights),x.push(E.numSpotLights),x.push(E.numSpotLightMaps),x.push(E.numHemiLights),x.push(E.numRectAreaLights),x.push(E.numSunLightShadows),x.push(E.numDirLightShadows),x.push(E.numPointLightShadows),x.push(E.numSpotLightShadows),x.push(E.numSpotLightShadowsWithMaps),x.push(E.numLightProbes),x.push(E.numLightProbeGrids),x.push(E.shadowMapType),x.push(E.toneMapping),x.push(E.numClippingPlanes),x.push(E.numClipIntersection),x.push(E.depthPacking)}function m(x,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let E=d[x.type],k;if(E){let D=bs[E];k=P0.clone(D.uniforms)}else k=x.uniforms;return k}function M(x,E){let k=h.get(E);return k!==void 0?++k.usedTimes:(k=new ET(i,E,x,s),l.push(k),h.set(E,k)),k}function b(x){if(--x.usedTimes===0){let E=l.indexOf(x);l[E]=l[l.length-1],l.pop(),h.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function A(){a.dispose()}return{getParameters:p,getProgramCacheKey:v,getUniforms:y,acquireProgram:M,releaseProgram:b,releaseShaderCache:C,programs:l,dispose:A}}function PT(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function IT(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function j0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Z0(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,v,g,m){let y=i[e];return y===void 0?(y={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:v,renderOrder:d.renderOrder,z:g,group:m},i[e]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=p,y.materialVariant=o(d),y.groupOrder=v,y.renderOrder=d.renderOrder,y.z=g,y.group=m),e++,y}function c(d,f,p,v,g,m,y){y.reversedDepth===!0&&(g=-g);let M=a(d,f,p,v,g,m);p.transmission>0?n.push(M):p.transparent===!0?s.push(M):t.push(M)}function l(d,f,p,v,g,m){let y=a(d,f,p,v,g,m);p.transmission>0?n.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function h(d,f){t.length>1&&t.sort(d||IT),n.length>1&&n.sort(f||j0),s.length>1&&s.sort(f||j0)}function u(){for(let d=e,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:u,sort:h}}function LT(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Z0,i.set(n,[o])):s>=r.length?(o=new Z0,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function NT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new V,color:new Ke};break;case"SpotLight":t={position:new V,direction:new V,color:new Ke,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new V,color:new Ke,distance:0,decay:0};break;case"HemisphereLight":t={direction:new V,skyColor:new Ke,groundColor:new Ke};break;case"RectAreaLight":t={color:new Ke,position:new V,halfWidth:new V,halfHeight:new V};break}return i[e.id]=t,t}}}function DT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var OT=0;function UT(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function FT(i){let e=new NT,t=DT(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new V);let s=new V,r=new ct,o=new ct;function a(l){let h=0,u=0,d=0;for(let W=0;W<9;W++)n.probe[W].set(0,0,0);let f=0,p=0,v=0,g=0,m=0,y=0,M=0,b=0,C=0,A=0,x=0,E=0,k=0,D=0;l.sort(UT);for(let W=0,X=l.length;W<X;W++){let O=l[W],H=O.color,Y=O.intensity,B=O.distance,ce=null;if(O.shadow&&O.shadow.map&&(O.shadow.map.texture.format===vr?ce=O.shadow.map.texture:ce=O.shadow.map.depthTexture||O.shadow.map.texture),O.isAmbientLight)h+=H.r*Y,u+=H.g*Y,d+=H.b*Y;else if(O.isLightProbe){for(let Z=0;Z<9;Z++)n.probe[Z].addScaledVector(O.sh.coefficients[Z],Y);D++}else if(O.isSunLight){let Z=e.get(O);if(Z.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let ee=O.shadow,se=t.get(O);se.shadowIntensity=ee.intensity,se.shadowBias=ee.bias,se.shadowNormalBias=ee.normalBias,se.shadowRadius=ee.radius,se.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),n.sunShadow[p]=se,n.sunShadowMap[p]=ce;let fe=ee.getViewportCount();for(let de=0;de<fe;de++)n.sunShadowMatrix[v+de]=ee.getMatrix(de),n.sunShadowCascade[v+de]=ee._cascadeData[de];v+=fe,p++}n.sun[f]=Z,f++}else if(O.isDirectionalLight){let Z=e.get(O);if(Z.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let ee=O.shadow,se=t.get(O);se.shadowIntensity=ee.intensity,se.shadowBias=ee.bias,se.shadowNormalBias=ee.normalBias,se.shadowRadius=ee.radius,se.shadowMapSize=ee.mapSize,n.directionalShadow[g]=se,n.directionalShadowMap[g]=ce,n.directionalShadowMatrix[g]=O.shadow.matrix,C++}n.directional[g]=Z,g++}else if(O.isSpotLight){let Z=e.get(O);Z.position.setFromMatrixPosition(O.matrixWorld),Z.color.copy(H).multiplyScalar(Y),Z.distance=B,Z.coneCos=Math.cos(O.angle),Z.penumbraCos=Math.cos(O.angle*(1-O.penumbra)),Z.decay=O.decay,n.spot[y]=Z;let ee=O.shadow;if(O.map&&(n.spotLightMap[E]=O.map,E++,ee.updateMatrices(O),O.castShadow&&k++),n.spotLightMatrix[y]=ee.matrix,O.castShadow){let se=t.get(O);se.shadowIntensity=ee.intensity,se.shadowBias=ee.bias,se.shadowNormalBias=ee.normalBias,se.shadowRadius=ee.radius,se.shadowMapSize=ee.mapSize,n.spotShadow[y]=se,n.spotShadowMap[y]=ce,x++}y++}else if(O.isRectAreaLight){let Z=e.get(O);Z.color.copy(H).multiplyScalar(Y),Z.halfWidth.set(O.width*.5,0,0),Z.halfHeight.set(0,O.height*.5,0),n.rectArea[M]=Z,M++}else if(O.isPointLight){let Z=e.get(O);if(Z.color.copy(O.color).multiplyScalar(O.intensity),Z.distance=O.distance,Z.decay=O.decay,O.castShadow){let ee=O.shadow,se=t.get(O);se.shadowIntensity=ee.intensity,se.shadowBias=ee.bias,se.shadowNormalBias=ee.normalBias,se.shadowRadius=ee.radius,se.shadowMapSize=ee.mapSize,se.shadowCameraNear=ee.camera.near,se.shadowCameraFar=ee.camera.far,n.pointShadow[m]=se,n.pointShadowMap[m]=ce,n.pointShadowMatrix[m]=O.shadow.matrix,A++}n.point[m]=Z,m++}else if(O.isHemisphereLight){let Z=e.get(O);Z.skyColor.copy(O.color).multiplyScalar(Y),Z.groundColor.copy(O.groundColor).multiplyScalar(Y),n.hemi[b]=Z,b++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Oe.LTC_FLOAT_1,n.rectAreaLTC2=Oe.LTC_FLOAT_2):(n.rectAreaLTC1=Oe.LTC_HALF_1,n.rectAreaLTC2=Oe.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let L=n.hash;(L.sunLength!==f||L.directionalLength!==g||L.pointLength!==m||L.spotLength!==y||L.rectAreaLength!==M||L.hemiLength!==b||L.numSunShadows!==p||L.numDirectionalShadows!==C||L.numPointShadows!==A||L.numSpotShadows!==x||L.numSpotMaps!==E||L.numLightProbes!==D)&&(n.sun.length=f,n.directional.length=g,n.spot.length=y,n.rectArea.length=M,n.point.length=m,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+E-k,n.spotLightMap.length=E,n.numSpotLightShadowsWithMaps=k,n.numLightProbes=D,L.sunLength=f,L.directionalLength=g,L.pointLength=m,L.spotLength=y,L.rectAreaLength=M,L.hemiLength=b,L.numSunShadows=p,L.numDirectionalShadows=C,L.numPointShadows=A,L.numSpotShadows=x,L.numSpotMaps=E,L.numLightProbes=D,n.version=OT++)}function c(l,h){let u=0,d=0,f=0,p=0,v=0,g=0,m=h.matrixWorldInverse;for(let y=0,M=l.length;y<M;y++){let b=l[y];if(b.isSunLight){let C=n.sun[u];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(m),u++}else if(b.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),d++}else if(b.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),p++}else if(b.isRectAreaLight){let C=n.rectArea[v];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),v++}else if(b.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),f++}else if(b.isHemisphereLight){let C=n.hemi[g];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(m),g++}}}return{setup:a,setupView:c,state:n}}function J0(i){let e=new FT(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function c(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function l(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function kT(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new J0(i),e.set(s,[a])):r>=o.length?(a=new J0(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var BT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,zT=`uniform sampler2D shadow_pass;
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
}`,HT=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],VT=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],Q0=new ct,Tl=new V,kf=new V;function GT(i,e,t){let n=new pr,s=new je,r=new je,o=new Dt,a=new qc,c=new $c,l={},h=t.maxTextureSize,u={[xs]:ri,[ri]:xs,[fi]:fi},d=new ps({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new je},radius:{value:4}},vertexShader:BT,fragmentShader:zT}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Vn;p.setAttribute("position",new ln(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Zt(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=xl;let m=this.type;this.render=function(A,x,E){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===Yg&&(qe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=xl);let k=i.getRenderTarget(),D=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),W=i.state;W.setBlending(Yr),W.buffers.depth.getReversed()===!0?W.buffers.color.setClear(0,0,0,0):W.buffers.color.setClear(1,1,1,1),W.buffers.depth.setTest(!0),W.setScissorTest(!1);let X=m!==this.type;X&&x.traverse(function(O){O.material&&(Array.isArray(O.material)?O.material.forEach(H=>H.needsUpdate=!0):O.material.needsUpdate=!0)});for(let O=0,H=A.length;O<H;O++){let Y=A[O],B=Y.shadow;if(B===void 0){qe("WebGLShadowMap:",Y,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let ce=B.getFrameExtents();s.multiply(ce),r.copy(B.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ce.x),s.x=r.x*ce.x,B.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ce.y),s.y=r.y*ce.y,B.mapSize.y=r.y));let Z=i.state.buffers.depth.getReversed();if(B.camera._reversedDepth=Z,B.map===null||X===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===ta){if(Y.isPointLight){qe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new Si(s.x,s.y,{format:vr,type:Zi,minFilter:Sn,magFilter:Sn,generateMipmaps:!1}),B.map.texture.name=Y.name+".shadowMap",B.map.depthTexture=new zs(s.x,s.y,Mi),B.map.depthTexture.name=Y.name+".shadowMapDepth",B.map.depthTexture.format=Fs,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=cn,B.map.depthTexture.magFilter=cn}else Y.isPointLight?(B.map=new Al(s.x),B.map.depthTexture=new sl(s.x,ji)):(B.map=new Si(s.x,s.y),B.map.depthTexture=new zs(s.x,s.y,ji)),B.map.depthTexture.name=Y.name+".shadowMap",B.map.depthTexture.format=Fs,this.type===xl?(B.map.depthTexture.compareFunction=Z?Tf:wf,B.map.depthTexture.minFilter=Sn,B.map.depthTexture.magFilter=Sn):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=cn,B.map.depthTexture.magFilter=cn);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);let ee=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();Y.isPointLight!==!0&&B.updateMatrices(Y,E);let se=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:E.layers;for(let fe=0;fe<ee;fe++){let de=B.getCamera(fe);if(Y.isPointLight){let te=B.camera,ge=B.matrix,ve=Y.distance||te.far;ve!==te.far&&(te.far=ve,te.updateProjectionMatrix()),Tl.setFromMatrixPosition(Y.matrixWorld),te.position.copy(Tl),kf.copy(te.position),kf.add(HT[fe]),te.up.copy(VT[fe]),te.lookAt(kf),te.updateMatrixWorld(),ge.makeTranslation(-Tl.x,-Tl.y,-Tl.z),Q0.multiplyMatrices(te.projectionMatrix,te.matrixWorldInverse),B._frustum.setFromProjectionMatrix(Q0,te.coordinateSystem,te.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)i.setRenderTarget(B.map,fe),i.clear();else{fe===0&&(i.setRenderTarget(B.map),i.clear());let te=B.getViewport(fe);o.set(r.x*te.x,r.y*te.y,r.x*te.z,r.y*te.w),W.viewport(o)}n=B.getFrustum(fe),b(x,E,de,Y,se,this.type)}B.isPointLightShadow!==!0&&this.type===ta&&y(B,E),B.needsUpdate=!1}m=this.type,g.needsUpdate=!1,i.setRenderTarget(k,D,L)};function y(A,x){let E=e.update(v);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new Si(s.x,s.y,{format:vr,type:Zi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),d.uniforms.shadow_pass.value=A.map.depthTexture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(x,null,E,d,v,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(x,null,E,f,v,null)}function M(A,x,E,k){let D=null,L=E.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(L!==void 0)D=L;else if(D=E.isPointLight===!0?c:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let W=D.uuid,X=x.uuid,O=l[W];O===void 0&&(O={},l[W]=O);let H=O[X];H===void 0&&(H=D.clone(),O[X]=H,x.addEventListener("dispose",C)),D=H}if(D.visible=x.visible,D.wireframe=x.wireframe,k===ta?D.side=x.shadowSide!==null?x.shadowSide:x.side:D.side=x.shadowSide!==null?x.shadowSide:u[x.side],D.alphaMap=x.alphaMap,D.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,D.map=x.map,D.clipShadows=x.clipShadows,D.clippingPlanes=x.clippingPlanes,D.clipIntersection=x.clipIntersection,D.displacementMap=x.displacementMap,D.displacementScale=x.displacementScale,D.displacementBias=x.displacementBias,D.wireframeLinewidth=x.wireframeLinewidth,D.linewidth=x.linewidth,E.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let W=i.properties.get(D);W.light=E}return D}function b(A,x,E,k,D,L){if(A.visible===!1)return;if(A.layers.test(D)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&L===ta)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,A.matrixWorld);let O=e.update(A),H=A.material;if(Array.isArray(H)){let Y=O.groups;for(let B=0,ce=Y.length;B<ce;B++){let Z=Y[B],ee=H[Z.materialIndex];if(ee&&ee.visible){let se=M(A,ee,k,L);A.onBeforeShadow(i,A,x,E,O,se,Z),i.renderBufferDirect(E,null,O,se,A,Z),A.onAfterShadow(i,A,x,E,O,se,Z)}}}else if(H.visible){let Y=M(A,H,k,L);A.onBeforeShadow(i,A,x,E,O,Y,null),i.renderBufferDirect(E,null,O,Y,A,null),A.onAfterShadow(i,A,x,E,O,Y,null)}}let X=A.children;for(let O=0,H=X.length;O<H;O++)b(X[O],x,E,k,D,L)}function C(A){A.target.removeEventListener("dispose",C);for(let E in l){let k=l[E],D=A.target.uuid;D in k&&(k[D].dispose(),delete k[D])}}}function WT(i,e){function t(){let U=!1,oe=new Dt,ie=null,Te=new Dt(0,0,0,0);return{setMask:function(xe){ie!==xe&&!U&&(i.colorMask(xe,xe,xe,xe),ie=xe)},setLocked:function(xe){U=xe},setClear:function(xe,Se,Xe,et,he){he===!0&&(xe*=et,Se*=et,Xe*=et),oe.set(xe,Se,Xe,et),Te.equals(oe)===!1&&(i.clearColor(xe,Se,Xe,et),Te.copy(oe))},reset:function(){U=!1,ie=null,Te.set(-1,0,0,0)}}}function n(){let U=!1,oe=!1,ie=null,Te=null,xe=null;return{setReversed:function(Se){if(oe!==Se){let Xe=e.get("EXT_clip_control");Se?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),oe=Se;let et=xe;xe=null,this.setClear(et)}},getReversed:function(){return oe},setTest:function(Se){Se?Me(i.DEPTH_TEST):$e(i.DEPTH_TEST)},setMask:function(Se){ie!==Se&&!U&&(i.depthMask(Se),ie=Se)},setFunc:function(Se){if(oe&&(Se=R0[Se]),Te!==Se){switch(Se){case Lc:i.depthFunc(i.NEVER);break;case Nc:i.depthFunc(i.ALWAYS);break;case Dc:i.depthFunc(i.LESS);break;case Uo:i.depthFunc(i.LEQUAL);break;case Oc:i.depthFunc(i.EQUAL);break;case Uc:i.depthFunc(i.GEQUAL);break;case Fc:i.depthFunc(i.GREATER);break;case kc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Te=Se}},setLocked:function(Se){U=Se},setClear:function(Se){xe!==Se&&(xe=Se,oe&&(Se=1-Se),i.clearDepth(Se))},reset:function(){U=!1,ie=null,Te=null,xe=null,oe=!1}}}function s(){let U=!1,oe=null,ie=null,Te=null,xe=null,Se=null,Xe=null,et=null,he=null;return{setTest:function(ze){U||(ze?Me(i.STENCIL_TEST):$e(i.STENCIL_TEST))},setMask:function(ze){oe!==ze&&!U&&(i.stencilMask(ze),oe=ze)},setFunc:function(ze,tt,Pe){(ie!==ze||Te!==tt||xe!==Pe)&&(i.stencilFunc(ze,tt,Pe),ie=ze,Te=tt,xe=Pe)},setOp:function(ze,tt,Pe){(Se!==ze||Xe!==tt||et!==Pe)&&(i.stencilOp(ze,tt,Pe),Se=ze,Xe=tt,et=Pe)},setLocked:function(ze){U=ze},setClear:function(ze){he!==ze&&(i.clearStencil(ze),he=ze)},reset:function(){U=!1,oe=null,ie=null,Te=null,xe=null,Se=null,Xe=null,et=null,he=null}}}let r=new t,o=new n,a=new s,c={},l=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],v=null,g=!1,m=null,y=null,M=null,b=null,C=null,A=null,x=null,E=new Ke(0,0,0),k=0,D=!1,L=null,W=null,X=null,O=null,H=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),B=!1,ce=0,Z=i.getParameter(i.VERSION);Z.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(Z)[1]),B=ce>=1):Z.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),B=ce>=2);let ee=null,se={},fe=i.getParameter(i.SCISSOR_BOX),de=i.getParameter(i.VIEWPORT),te=new Dt().fromArray(fe),ge=new Dt().fromArray(de);function ve(U,oe,ie,Te){let xe=new Uint8Array(4),Se=i.createTexture();i.bindTexture(U,Se),i.texParameteri(U,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(U,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Xe=0;Xe<ie;Xe++)U===i.TEXTURE_3D||U===i.TEXTURE_2D_ARRAY?i.texImage3D(oe,0,i.RGBA,1,1,Te,0,i.RGBA,i.UNSIGNED_BYTE,xe):i.texImage2D(oe+Xe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,xe);return Se}let Ce={};Ce[i.TEXTURE_2D]=ve(i.TEXTURE_2D,i.TEXTURE_2D,1),Ce[i.TEXTURE_CUBE_MAP]=ve(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ce[i.TEXTURE_2D_ARRAY]=ve(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ce[i.TEXTURE_3D]=ve(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(i.DEPTH_TEST),o.setFunc(Uo),hn(!1),Ot(tf),Me(i.CULL_FACE),Yt(Yr);function Me(U){h[U]!==!0&&(i.enable(U),h[U]=!0)}function $e(U){h[U]!==!1&&(i.disable(U),h[U]=!1)}function at(U,oe){return d[U]!==oe?(i.bindFramebuffer(U,oe),d[U]=oe,U===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=oe),U===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=oe),!0):!1}function We(U,oe){let ie=p,Te=!1;if(U){ie=f.get(oe),ie===void 0&&(ie=[],f.set(oe,ie));let xe=U.textures;if(ie.length!==xe.length||ie[0]!==i.COLOR_ATTACHMENT0){for(let Se=0,Xe=xe.length;Se<Xe;Se++)ie[Se]=i.COLOR_ATTACHMENT0+Se;ie.length=xe.length,Te=!0}}else ie[0]!==i.BACK&&(ie[0]=i.BACK,Te=!0);Te&&i.drawBuffers(ie)}function pt(U){return v!==U?(i.useProgram(U),v=U,!0):!1}let ut={[Kr]:i.FUNC_ADD,[jg]:i.FUNC_SUBTRACT,[Zg]:i.FUNC_REVERSE_SUBTRACT};ut[Jg]=i.MIN,ut[Qg]=i.MAX;let rt={[e0]:i.ZERO,[t0]:i.ONE,[n0]:i.SRC_COLOR,[of]:i.SRC_ALPHA,[l0]:i.SRC_ALPHA_SATURATE,[o0]:i.DST_COLOR,[s0]:i.DST_ALPHA,[i0]:i.ONE_MINUS_SRC_COLOR,[af]:i.ONE_MINUS_SRC_ALPHA,[a0]:i.ONE_MINUS_DST_COLOR,[r0]:i.ONE_MINUS_DST_ALPHA,[c0]:i.CONSTANT_COLOR,[h0]:i.ONE_MINUS_CONSTANT_COLOR,[u0]:i.CONSTANT_ALPHA,[d0]:i.ONE_MINUS_CONSTANT_ALPHA};function Yt(U,oe,ie,Te,xe,Se,Xe,et,he,ze){if(U===Yr){g===!0&&($e(i.BLEND),g=!1);return}if(g===!1&&(Me(i.BLEND),g=!0),U!==Kg){if(U!==m||ze!==D){if((y!==Kr||C!==Kr)&&(i.blendEquation(i.FUNC_ADD),y=Kr,C=Kr),ze)switch(U){case na:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case nf:i.blendFunc(i.ONE,i.ONE);break;case sf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case rf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:nt("WebGLState: Invalid blending: ",U);break}else switch(U){case na:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case nf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case sf:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case rf:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",U);break}M=null,b=null,A=null,x=null,E.set(0,0,0),k=0,m=U,D=ze}return}xe=xe||oe,Se=Se||ie,Xe=Xe||Te,(oe!==y||xe!==C)&&(i.blendEquationSeparate(ut[oe],ut[xe]),y=oe,C=xe),(ie!==M||Te!==b||Se!==A||Xe!==x)&&(i.blendFuncSeparate(rt[ie],rt[Te],rt[Se],rt[Xe]),M=ie,b=Te,A=Se,x=Xe),(et.equals(E)===!1||he!==k)&&(i.blendColor(et.r,et.g,et.b,he),E.copy(et),k=he),m=U,D=!1}function Vt(U,oe){U.side===fi?$e(i.CULL_FACE):Me(i.CULL_FACE);let ie=U.side===ri;oe&&(ie=!ie),hn(ie),U.blending===na&&U.transparent===!1?Yt(Yr):Yt(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),r.setMask(U.colorWrite);let Te=U.stencilWrite;a.setTest(Te),Te&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),Mt(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?Me(i.SAMPLE_ALPHA_TO_COVERAGE):$e(i.SAMPLE_ALPHA_TO_COVERAGE)}function hn(U){L!==U&&(U?i.frontFace(i.CW):i.frontFace(i.CCW),L=U)}function Ot(U){U!==qg?(Me(i.CULL_FACE),U!==W&&(U===tf?i.cullFace(i.BACK):U===$g?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):$e(i.CULL_FACE),W=U}function Pn(U){U!==X&&(B&&i.lineWidth(U),X=U)}function Mt(U,oe,ie){U?(Me(i.POLYGON_OFFSET_FILL),(O!==oe||H!==ie)&&(O=oe,H=ie,o.getReversed()&&(oe=-oe,ie=-ie),i.polygonOffset(oe,ie))):$e(i.POLYGON_OFFSET_FILL)}function _n(U){U?Me(i.SCISSOR_TEST):$e(i.SCISSOR_TEST)}function en(U){U===void 0&&(U=i.TEXTURE0+Y-1),ee!==U&&(i.activeTexture(U),ee=U)}function un(U,oe,ie){ie===void 0&&(ee===null?ie=i.TEXTURE0+Y-1:ie=ee);let Te=se[ie];Te===void 0&&(Te={type:void 0,texture:void 0},se[ie]=Te),(Te.type!==U||Te.texture!==oe)&&(ee!==ie&&(i.activeTexture(ie),ee=ie),i.bindTexture(U,oe||Ce[U]),Te.type=U,Te.texture=oe)}function F(){let U=se[ee];U!==void 0&&U.type!==void 0&&(i.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Ie(){try{i.compressedTexImage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function Je(){try{i.compressedTexImage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function lt(){try{i.texSubImage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function we(){try{i.texSubImage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function kt(){try{i.compressedTexSubImage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function Ge(){try{i.compressedTexSubImage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function Ze(){try{i.texStorage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function P(){try{i.texStorage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function S(){try{i.texImage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function $(){try{i.texImage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function ue(U){return u[U]!==void 0?u[U]:i.getParameter(U)}function ae(U,oe){u[U]!==oe&&(i.pixelStorei(U,oe),u[U]=oe)}function _e(U){te.equals(U)===!1&&(i.scissor(U.x,U.y,U.z,U.w),te.copy(U))}function ye(U){ge.equals(U)===!1&&(i.viewport(U.x,U.y,U.z,U.w),ge.copy(U))}function ne(U,oe){let ie=l.get(oe);ie===void 0&&(ie=new WeakMap,l.set(oe,ie));let Te=ie.get(U);Te===void 0&&(Te=i.getUniformBlockIndex(oe,U.name),i.uniformBlockBinding(oe,Te,Te),ie.set(U,Te))}function re(U,oe,ie){let xe=l.get(oe).get(U);c[xe]!==ie&&(i.bindBufferBase(i.UNIFORM_BUFFER,xe,ie),c[xe]=ie)}function me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},ee=null,se={},d={},c={},f=new WeakMap,p=[],v=null,g=!1,m=null,y=null,M=null,b=null,C=null,A=null,x=null,E=new Ke(0,0,0),k=0,D=!1,L=null,W=null,X=null,O=null,H=null,te.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Me,disable:$e,bindFramebuffer:at,drawBuffers:We,useProgram:pt,setBlending:Yt,setMaterial:Vt,setFlipSided:hn,setCullFace:Ot,setLineWidth:Pn,setPolygonOffset:Mt,setScissorTest:_n,activeTexture:en,bindTexture:un,unbindTexture:F,compressedTexImage2D:Ie,compressedTexImage3D:Je,texImage2D:S,texImage3D:$,pixelStorei:ae,getParameter:ue,updateUBOMapping:ne,uniformBlockBinding:re,texStorage2D:Ze,texStorage3D:P,texSubImage2D:lt,texSubImage3D:we,compressedTexSubImage2D:kt,compressedTexSubImage3D:Ge,scissor:_e,viewport:ye,reset:me}}function XT(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new je,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,v=new FinalizationRegistry(P=>p.delete(P)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(P,S){return g?new OffscreenCanvas(P,S):Bo("canvas")}function y(P,S,$){let ue=1,ae=Ze(P);if((ae.width>$||ae.height>$)&&(ue=$/Math.max(ae.width,ae.height)),ue<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let _e=Math.floor(ue*ae.width),ye=Math.floor(ue*ae.height);d===void 0&&(d=m(_e,ye));let ne=S?m(_e,ye):d;return ne.width=_e,ne.height=ye,ne.getContext("2d").drawImage(P,0,0,_e,ye),qe("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+_e+"x"+ye+")."),ne}else return"data"in P&&qe("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),P;return P}function M(P){return P.generateMipmaps}function b(P){i.generateMipmap(P)}function C(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(P,S,$,ue,ae,_e=!1){if(P!==null){if(i[P]!==void 0)return i[P];qe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||qe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=S;if(S===i.RED&&($===i.FLOAT&&(ne=i.R32F),$===i.HALF_FLOAT&&(ne=i.R16F),$===i.UNSIGNED_BYTE&&(ne=i.R8),$===i.UNSIGNED_SHORT&&ye&&(ne=ye.R16_EXT),$===i.SHORT&&ye&&(ne=ye.R16_SNORM_EXT)),S===i.RED_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.R8UI),$===i.UNSIGNED_SHORT&&(ne=i.R16UI),$===i.UNSIGNED_INT&&(ne=i.R32UI),$===i.BYTE&&(ne=i.R8I),$===i.SHORT&&(ne=i.R16I),$===i.INT&&(ne=i.R32I)),S===i.RG&&($===i.FLOAT&&(ne=i.RG32F),$===i.HALF_FLOAT&&(ne=i.RG16F),$===i.UNSIGNED_BYTE&&(ne=i.RG8),$===i.UNSIGNED_SHORT&&ye&&(ne=ye.RG16_EXT),$===i.SHORT&&ye&&(ne=ye.RG16_SNORM_EXT)),S===i.RG_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RG8UI),$===i.UNSIGNED_SHORT&&(ne=i.RG16UI),$===i.UNSIGNED_INT&&(ne=i.RG32UI),$===i.BYTE&&(ne=i.RG8I),$===i.SHORT&&(ne=i.RG16I),$===i.INT&&(ne=i.RG32I)),S===i.RGB_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RGB8UI),$===i.UNSIGNED_SHORT&&(ne=i.RGB16UI),$===i.UNSIGNED_INT&&(ne=i.RGB32UI),$===i.BYTE&&(ne=i.RGB8I),$===i.SHORT&&(ne=i.RGB16I),$===i.INT&&(ne=i.RGB32I)),S===i.RGBA_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RGBA8UI),$===i.UNSIGNED_SHORT&&(ne=i.RGBA16UI),$===i.UNSIGNED_INT&&(ne=i.RGBA32UI),$===i.BYTE&&(ne=i.RGBA8I),$===i.SHORT&&(ne=i.RGBA16I),$===i.INT&&(ne=i.RGBA32I)),S===i.RGB&&($===i.UNSIGNED_SHORT&&ye&&(ne=ye.RGB16_EXT),$===i.SHORT&&ye&&(ne=ye.RGB16_SNORM_EXT),$===i.UNSIGNED_INT_5_9_9_9_REV&&(ne=i.RGB9_E5),$===i.UNSIGNED_INT_10F_11F_11F_REV&&(ne=i.R11F_G11F_B10F)),S===i.RGBA){let re=_e?Xa:mt.getTransfer(ae);$===i.FLOAT&&(ne=i.RGBA32F),$===i.HALF_FLOAT&&(ne=i.RGBA16F),$===i.UNSIGNED_BYTE&&(ne=re===Ct?i.SRGB8_ALPHA8:i.RGBA8),$===i.UNSIGNED_SHORT&&ye&&(ne=ye.RGBA16_EXT),$===i.SHORT&&ye&&(ne=ye.RGBA16_SNORM_EXT),$===i.UNSIGNED_SHORT_4_4_4_4&&(ne=i.RGBA4),$===i.UNSIGNED_SHORT_5_5_5_1&&(ne=i.RGB5_A1)}return(ne===i.R16F||ne===i.R32F||ne===i.RG16F||ne===i.RG32F||ne===i.RGBA16F||ne===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function x(P,S){let $;return P?S===null||S===ji||S===Jr?$=i.DEPTH24_STENCIL8:S===Mi?$=i.DEPTH32F_STENCIL8:S===ra&&($=i.DEPTH24_STENCIL8,qe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===ji||S===Jr?$=i.DEPTH_COMPONENT24:S===Mi?$=i.DEPTH_COMPONENT32F:S===ra&&($=i.DEPTH_COMPONENT16),$}function E(P,S){return M(P)===!0||P.isFramebufferTexture&&P.minFilter!==cn&&P.minFilter!==Sn?Math.log2(Math.max(S.width,S.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?S.mipmaps.length:1}function k(P){let S=new WeakRef(P);n.get(P).__ref=S,p.add(S),v.register(P,S,S)}function D(P){let S=n.get(P).__ref;S!==void 0&&(p.delete(S),v.unregister(S))}function L(P){X(P.target)}function W(P){O(P.target)}function X(P){P.removeEventListener("dispose",L),D(P),Y(P),P.isVideoTexture&&h.delete(P),P.isHTMLTexture&&u.delete(P)}function O(P){P.removeEventListener("dispose",W),D(P),ce(P)}function H(){for(let P of p){let S=P.deref();S!==void 0&&(S.isRenderTarget===!0?O(S):X(S))}p.clear(),u.clear()}function Y(P){let S=n.get(P);if(S.__webglInit===void 0)return;let $=P.source,ue=f.get($);if(ue){let ae=ue[S.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&B(P),Object.keys(ue).length===0&&f.delete($)}n.remove(P)}function B(P){let S=n.get(P);i.deleteTexture(S.__webglTexture);let $=P.source,ue=f.get($);delete ue[S.__cacheKey],o.memory.textures--}function ce(P){let S=n.get(P);S.__depthDisposeCallback&&S.__depthDisposeCallback();let $=P.depthTexture;if($&&$.renderTarget===P&&X($),P.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(S.__webglFramebuffer[ae]))for(let _e=0;_e<S.__webglFramebuffer[ae].length;_e++)i.deleteFramebuffer(S.__webglFramebuffer[ae][_e]);else i.deleteFramebuffer(S.__webglFramebuffer[ae]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[ae])}else{if(Array.isArray(S.__webglFramebuffer))for(let ae=0;ae<S.__webglFramebuffer.length;ae++)i.deleteFramebuffer(S.__webglFramebuffer[ae]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ae=0;ae<S.__webglColorRenderbuffer.length;ae++)S.__webglColorRenderbuffer[ae]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[ae]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ue=P.textures;for(let ae=0,_e=ue.length;ae<_e;ae++){let ye=n.get(ue[ae]);ye.__webglTexture&&(i.deleteTexture(ye.__webglTexture),o.memory.textures--),n.remove(ue[ae])}n.remove(P)}let Z=0;function ee(){Z=0}function se(){return Z}function fe(P){Z=P}function de(){let P=Z;return P>=s.maxTextures&&qe("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,P}function te(P){let S=[];return S.push(P.wrapS),S.push(P.wrapT),S.push(P.wrapR||0),S.push(P.magFilter),S.push(P.minFilter),S.push(P.anisotropy),S.push(P.internalFormat),S.push(P.format),S.push(P.type),S.push(P.generateMipmaps),S.push(P.mipmapsAutoUpdate),S.push(P.premultiplyAlpha),S.push(P.flipY),S.push(P.unpackAlignment),S.push(P.colorSpace),S.join()}function ge(P,S){let $=n.get(P);if(P.isVideoTexture&&kt(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&$.__version!==P.version){let ue=P.image;if(ue===null)qe("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)qe("WebGLRenderer: Texture marked for update but image is incomplete");else{Vt($,P,S);return}}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,$.__webglTexture,i.TEXTURE0+S)}function ve(P,S){let $=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){Vt($,P,S);return}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,$.__webglTexture,i.TEXTURE0+S)}function Ce(P,S){let $=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){Vt($,P,S);return}t.bindTexture(i.TEXTURE_3D,$.__webglTexture,i.TEXTURE0+S)}function Me(P,S){let $=n.get(P);if(P.version>0&&$.__version!==P.version){hn($,P,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,$.__webglTexture,i.TEXTURE0+S)}let $e={[fr]:i.REPEAT,[Oi]:i.CLAMP_TO_EDGE,[Fo]:i.MIRRORED_REPEAT},at={[cn]:i.NEAREST,[sh]:i.NEAREST_MIPMAP_NEAREST,[Zr]:i.NEAREST_MIPMAP_LINEAR,[Sn]:i.LINEAR,[sa]:i.LINEAR_MIPMAP_NEAREST,[Fi]:i.LINEAR_MIPMAP_LINEAR},We={[y0]:i.NEVER,[Ef]:i.ALWAYS,[b0]:i.LESS,[wf]:i.LEQUAL,[S0]:i.EQUAL,[Tf]:i.GEQUAL,[M0]:i.GREATER,[w0]:i.NOTEQUAL};function pt(P,S){if(S.type===Mi&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===Sn||S.magFilter===sa||S.magFilter===Zr||S.magFilter===Fi||S.minFilter===Sn||S.minFilter===sa||S.minFilter===Zr||S.minFilter===Fi)&&qe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,$e[S.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,$e[S.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,$e[S.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,at[S.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,at[S.minFilter]),S.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,We[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===cn||S.minFilter!==Zr&&S.minFilter!==Fi||S.type===Mi&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");i.texParameterf(P,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function ut(P,S){let $=!1;P.__webglInit===void 0&&(P.__webglInit=!0,S.addEventListener("dispose",L),k(S));let ue=S.source,ae=f.get(ue);ae===void 0&&(ae={},f.set(ue,ae));let _e=te(S);if(_e!==P.__cacheKey){ae[_e]===void 0&&(ae[_e]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ae[_e].usedTimes++;let ye=ae[P.__cacheKey];ye!==void 0&&(ae[P.__cacheKey].usedTimes--,ye.usedTimes===0&&B(S)),P.__cacheKey=_e,P.__webglTexture=ae[_e].texture}return $}function rt(P,S,$){return Math.floor(Math.floor(P/$)/S)}function Yt(P,S,$,ue){let _e=P.updateRanges;if(_e.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,$,ue,S.data);else{_e.sort((U,oe)=>U.start-oe.start);let ye=0;for(let U=1;U<_e.length;U++){let oe=_e[ye],ie=_e[U],Te=oe.start+oe.count,xe=rt(ie.start,S.width,4),Se=rt(oe.start,S.width,4);ie.start<=Te+1&&xe===Se&&rt(ie.start+ie.count-1,S.width,4)===xe?oe.count=Math.max(oe.count,ie.start+ie.count-oe.start):(++ye,_e[ye]=ie)}_e.length=ye+1;let ne=t.getParameter(i.UNPACK_ROW_LENGTH),re=t.getParameter(i.UNPACK_SKIP_PIXELS),me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let U=0,oe=_e.length;U<oe;U++){let ie=_e[U],Te=Math.floor(ie.start/4),xe=Math.ceil(ie.count/4),Se=Te%S.width,Xe=Math.floor(Te/S.width),et=xe,he=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(i.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(i.TEXTURE_2D,0,Se,Xe,et,he,$,ue,S.data)}P.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ne),t.pixelStorei(i.UNPACK_SKIP_PIXELS,re),t.pixelStorei(i.UNPACK_SKIP_ROWS,me)}}function Vt(P,S,$){let ue=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ue=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ue=i.TEXTURE_3D);let ae=ut(P,S),_e=S.source;t.bindTexture(ue,P.__webglTexture,i.TEXTURE0+$);let ye=n.get(_e);if(_e.version!==ye.__version||ae===!0){if(t.activeTexture(i.TEXTURE0+$),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let he=mt.getPrimaries(mt.workingColorSpace),ze=S.colorSpace===Ys?null:mt.getPrimaries(S.colorSpace),tt=S.colorSpace===Ys||he===ze?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let re=y(S.image,!1,s.maxTextureSize);re=Ge(S,re);let me=r.convert(S.format,S.colorSpace),U=r.convert(S.type),oe=A(S.internalFormat,me,U,S.normalized,S.colorSpace,S.isVideoTexture);pt(ue,S);let ie,Te=S.mipmaps,xe=S.isVideoTexture!==!0,Se=ye.__version===void 0||ae===!0,Xe=_e.dataReady,et=E(S,re);if(S.isDepthTexture)oe=x(S.format===$s,S.type),Se&&(xe?t.texStorage2D(i.TEXTURE_2D,1,oe,re.width,re.height):t.texImage2D(i.TEXTURE_2D,0,oe,re.width,re.height,0,me,U,null));else if(S.isDataTexture)if(Te.length>0){xe&&Se&&t.texStorage2D(i.TEXTURE_2D,et,oe,Te[0].width,Te[0].height);for(let he=0,ze=Te.length;he<ze;he++)ie=Te[he],xe?Xe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,me,U,ie.data):t.texImage2D(i.TEXTURE_2D,he,oe,ie.width,ie.height,0,me,U,ie.data);S.generateMipmaps=!1}else xe?(Se&&t.texStorage2D(i.TEXTURE_2D,et,oe,re.width,re.height),Xe&&Yt(S,re,me,U)):t.texImage2D(i.TEXTURE_2D,0,oe,re.width,re.height,0,me,U,re.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){xe&&Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,oe,Te[0].width,Te[0].height,re.depth);for(let he=0,ze=Te.length;he<ze;he++)if(ie=Te[he],S.format!==ki)if(me!==null)if(xe){if(Xe)if(S.layerUpdates.size>0){let tt=Uf(ie.width,ie.height,S.format,S.type);for(let Pe of S.layerUpdates){let ht=ie.data.subarray(Pe*tt/ie.data.BYTES_PER_ELEMENT,(Pe+1)*tt/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,Pe,ie.width,ie.height,1,me,ht)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,re.depth,me,ie.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,oe,ie.width,ie.height,re.depth,0,ie.data,0,0);else qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?Xe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,re.depth,me,U,ie.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,oe,ie.width,ie.height,re.depth,0,me,U,ie.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{xe&&Se&&t.texStorage2D(i.TEXTURE_2D,et,oe,Te[0].width,Te[0].height);for(let he=0,ze=Te.length;he<ze;he++)ie=Te[he],S.format!==ki?me!==null?xe?Xe&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,me,ie.data):t.compressedTexImage2D(i.TEXTURE_2D,he,oe,ie.width,ie.height,0,ie.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?Xe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,me,U,ie.data):t.texImage2D(i.TEXTURE_2D,he,oe,ie.width,ie.height,0,me,U,ie.data)}else if(S.isDataArrayTexture)if(xe){if(Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,oe,re.width,re.height,re.depth),Xe)if(S.layerUpdates.size>0){let he=Uf(re.width,re.height,S.format,S.type);for(let ze of S.layerUpdates){let tt=re.data.subarray(ze*he/re.data.BYTES_PER_ELEMENT,(ze+1)*he/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ze,re.width,re.height,1,me,U,tt)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,me,U,re.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,oe,re.width,re.height,re.depth,0,me,U,re.data);else if(S.isData3DTexture)xe?(Se&&t.texStorage3D(i.TEXTURE_3D,et,oe,re.width,re.height,re.depth),Xe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,me,U,re.data)):t.texImage3D(i.TEXTURE_3D,0,oe,re.width,re.height,re.depth,0,me,U,re.data);else if(S.isFramebufferTexture){if(Se)if(xe)t.texStorage2D(i.TEXTURE_2D,et,oe,re.width,re.height);else{let he=re.width,ze=re.height;for(let tt=0;tt<et;tt++)t.texImage2D(i.TEXTURE_2D,tt,oe,he,ze,0,me,U,null),he>>=1,ze>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let he=i.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),re.parentNode!==he){he.appendChild(re),u.add(S),he.onpaint=ze=>{let tt=ze.changedElements;for(let Pe of u)tt.includes(Pe.image)&&(Pe.needsUpdate=!0)},he.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,re);else{let tt=i.RGBA,Pe=i.RGBA,ht=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,tt,Pe,ht,re)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Te.length>0){if(xe&&Se){let he=Ze(Te[0]);t.texStorage2D(i.TEXTURE_2D,et,oe,he.width,he.height)}for(let he=0,ze=Te.length;he<ze;he++)ie=Te[he],xe?Xe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,me,U,ie):t.texImage2D(i.TEXTURE_2D,he,oe,me,U,ie);S.generateMipmaps=!1}else if(xe){if(Se){let he=Ze(re);t.texStorage2D(i.TEXTURE_2D,et,oe,he.width,he.height)}Xe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,me,U,re)}else t.texImage2D(i.TEXTURE_2D,0,oe,me,U,re);M(S)&&S.mipmapsAutoUpdate===!0&&b(ue),ye.__version=_e.version,S.onUpdate&&S.onUpdate(S)}P.__version=S.version}function hn(P,S,$){if(S.image.length!==6)return;let ue=ut(P,S),ae=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+$);let _e=n.get(ae);if(ae.version!==_e.__version||ue===!0){t.activeTexture(i.TEXTURE0+$);let ye=mt.getPrimaries(mt.workingColorSpace),ne=S.colorSpace===Ys?null:mt.getPrimaries(S.colorSpace),re=S.colorSpace===Ys||ye===ne?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let me=S.isCompressedTexture||S.image[0].isCompressedTexture,U=S.image[0]&&S.image[0].isDataTexture,oe=[];for(let Pe=0;Pe<6;Pe++)!me&&!U?oe[Pe]=y(S.image[Pe],!0,s.maxCubemapSize):oe[Pe]=U?S.image[Pe].image:S.image[Pe],oe[Pe]=Ge(S,oe[Pe]);let ie=oe[0],Te=r.convert(S.format,S.colorSpace),xe=r.convert(S.type),Se=A(S.internalFormat,Te,xe,S.normalized,S.colorSpace),Xe=S.isVideoTexture!==!0,et=_e.__version===void 0||ue===!0,he=ae.dataReady,ze=E(S,ie);pt(i.TEXTURE_CUBE_MAP,S);let tt;if(S.isDepthTexture){if(Se=x(S.format===$s,S.type),et)if(Xe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Se,ie.width,ie.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,ie.width,ie.height,0,Te,xe,null)}else if(me){Xe&&et&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,Se,ie.width,ie.height);for(let Pe=0;Pe<6;Pe++){tt=oe[Pe].mipmaps;for(let ht=0;ht<tt.length;ht++){let Gt=tt[ht];S.format!==ki?Te!==null?Xe?he&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,0,0,Gt.width,Gt.height,Te,Gt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,Se,Gt.width,Gt.height,0,Gt.data):qe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,0,0,Gt.width,Gt.height,Te,xe,Gt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,Se,Gt.width,Gt.height,0,Te,xe,Gt.data)}}}else{if(tt=S.mipmaps,Xe&&et){tt.length>0&&ze++;let Pe=Ze(oe[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,Se,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(U){Xe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,oe[Pe].width,oe[Pe].height,Te,xe,oe[Pe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,oe[Pe].width,oe[Pe].height,0,Te,xe,oe[Pe].data);for(let ht=0;ht<tt.length;ht++){let jn=tt[ht].image[Pe].image;Xe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,0,0,jn.width,jn.height,Te,xe,jn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,Se,jn.width,jn.height,0,Te,xe,jn.data)}}else{Xe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Te,xe,oe[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,Te,xe,oe[Pe]);for(let ht=0;ht<tt.length;ht++){let Gt=tt[ht];Xe?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,0,0,Te,xe,Gt.image[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,Se,Te,xe,Gt.image[Pe])}}}M(S)&&S.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),_e.__version=ae.version,S.onUpdate&&S.onUpdate(S)}P.__version=S.version}function Ot(P,S,$,ue,ae,_e){let ye=r.convert($.format,$.colorSpace),ne=r.convert($.type),re=A($.internalFormat,ye,ne,$.normalized,$.colorSpace),me=n.get(S),U=n.get($);if(U.__renderTarget=S,!me.__hasExternalTextures){let oe=Math.max(1,S.width>>_e),ie=Math.max(1,S.height>>_e);ae===i.TEXTURE_3D||ae===i.TEXTURE_2D_ARRAY?t.texImage3D(ae,_e,re,oe,ie,S.depth,0,ye,ne,null):t.texImage2D(ae,_e,re,oe,ie,0,ye,ne,null)}t.bindFramebuffer(i.FRAMEBUFFER,P),we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ue,ae,U.__webglTexture,0,lt(S)):(ae===i.TEXTURE_2D||ae>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ue,ae,U.__webglTexture,_e),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Pn(P,S,$){if(i.bindRenderbuffer(i.RENDERBUFFER,P),S.depthBuffer){let ue=S.depthTexture,ae=ue&&ue.isDepthTexture?ue.type:null,_e=x(S.stencilBuffer,ae),ye=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;we(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(S),_e,S.width,S.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(S),_e,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,_e,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ye,i.RENDERBUFFER,P)}else{let ue=S.textures;for(let ae=0;ae<ue.length;ae++){let _e=ue[ae],ye=r.convert(_e.format,_e.colorSpace),ne=r.convert(_e.type),re=A(_e.internalFormat,ye,ne,_e.normalized,_e.colorSpace);we(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(S),re,S.width,S.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(S),re,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,re,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Mt(P,S,$){let ue=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,P),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=n.get(S.depthTexture);ae.__renderTarget=S;let _e=ue?S.depthTexture.image[0]:S.depthTexture.image;(!ae.__webglTexture||_e.width!==S.width||_e.height!==S.height)&&(_e.width=S.width,_e.height=S.height,S.depthTexture.needsUpdate=!0),ue?Me(S.depthTexture,0):ge(S.depthTexture,0);let ye=ae.__webglTexture,ne=lt(S),re=ue?i.TEXTURE_CUBE_MAP_POSITIVE_X+$:i.TEXTURE_2D,me=S.depthTexture.format===$s?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===Fs)we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,re,ye,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,me,re,ye,0);else if(S.depthTexture.format===$s)we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,re,ye,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,me,re,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function _n(P){let S=n.get(P),$=P.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==P.depthTexture){let ue=P.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ue){let ae=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ue.removeEventListener("dispose",ae)};ue.addEventListener("dispose",ae),S.__depthDisposeCallback=ae}S.__boundDepthTexture=ue}if(P.depthTexture&&!S.__autoAllocateDepthBuffer)if($)for(let ue=0;ue<6;ue++)Mt(S.__webglFramebuffer[ue],P,ue);else P.texture.mipmaps.length>0?Mt(S.__webglFramebuffer[0],P,0):Mt(S.__webglFramebuffer,P,0);else if($){S.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[ue]),S.__webglDepthbuffer[ue]===void 0)S.__webglDepthbuffer[ue]=i.createRenderbuffer(),Pn(S.__webglDepthbuffer[ue],P,!1);else{let ae=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=S.__webglDepthbuffer[ue];i.bindRenderbuffer(i.RENDERBUFFER,_e),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,_e)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),Pn(S.__webglDepthbuffer,P,!1);else{let ae=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,_e),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,_e)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function en(P,S,$){let ue=n.get(P);S!==void 0&&Ot(ue.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),$!==void 0&&_n(P)}function un(P){let S=P.texture,$=n.get(P),ue=n.get(S);P.addEventListener("dispose",W),k(P);let ae=P.textures,_e=P.isWebGLCubeRenderTarget===!0,ye=ae.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=i.createTexture()),ue.__version=S.version,o.memory.textures++),_e){$.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0){$.__webglFramebuffer[ne]=[];for(let re=0;re<S.mipmaps.length;re++)$.__webglFramebuffer[ne][re]=i.createFramebuffer()}else $.__webglFramebuffer[ne]=i.createFramebuffer()}else{if(S.mipmaps.length>0){$.__webglFramebuffer=[];for(let ne=0;ne<S.mipmaps.length;ne++)$.__webglFramebuffer[ne]=i.createFramebuffer()}else $.__webglFramebuffer=i.createFramebuffer();if(ye)for(let ne=0,re=ae.length;ne<re;ne++){let me=n.get(ae[ne]);me.__webglTexture===void 0&&(me.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&we(P)===!1){$.__webglMultisampledFramebuffer=i.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let ne=0;ne<ae.length;ne++){let re=ae[ne];$.__webglColorRenderbuffer[ne]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,$.__webglColorRenderbuffer[ne]);let me=r.convert(re.format,re.colorSpace),U=r.convert(re.type),oe=A(re.internalFormat,me,U,re.normalized,re.colorSpace,P.isXRRenderTarget===!0),ie=lt(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,ie,oe,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ne,i.RENDERBUFFER,$.__webglColorRenderbuffer[ne])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&($.__webglDepthRenderbuffer=i.createRenderbuffer(),Pn($.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(_e){t.bindTexture(i.TEXTURE_CUBE_MAP,ue.__webglTexture),pt(i.TEXTURE_CUBE_MAP,S);for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0)for(let re=0;re<S.mipmaps.length;re++)Ot($.__webglFramebuffer[ne][re],P,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,re);else Ot($.__webglFramebuffer[ne],P,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);M(S)?b(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let ne=0,re=ae.length;ne<re;ne++){let me=ae[ne],U=n.get(me),oe=i.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(oe=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(oe,U.__webglTexture),pt(oe,me),Ot($.__webglFramebuffer,P,me,i.COLOR_ATTACHMENT0+ne,oe,0),M(me)&&b(oe)}t.unbindTexture()}else{let ne=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(ne=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ne,ue.__webglTexture),pt(ne,S),S.mipmaps.length>0)for(let re=0;re<S.mipmaps.length;re++)Ot($.__webglFramebuffer[re],P,S,i.COLOR_ATTACHMENT0,ne,re);else Ot($.__webglFramebuffer,P,S,i.COLOR_ATTACHMENT0,ne,0);M(S)?b(ne):S.mipmaps.length>0&&i.texParameteri(ne,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&_n(P)}function F(P){let S=P.textures;for(let $=0,ue=S.length;$<ue;$++){let ae=S[$];if(M(ae)&&ae.mipmapsAutoUpdate===!0){let _e=C(P),ye=n.get(ae).__webglTexture;t.bindTexture(_e,ye),b(_e),t.unbindTexture()}}}let Ie=[];function Je(P){if(P.samples>0){if(we(P)===!1){let S=P.textures,$=P.width,ue=P.height,ae=i.COLOR_BUFFER_BIT,_e=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=n.get(P),ne=S.length>1;if(ne)for(let me=0;me<S.length;me++)t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let me=0;me<S.length;me++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(ae|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(ae|=i.STENCIL_BUFFER_BIT)),ne){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let U=n.get(S[me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,U,0)}i.blitFramebuffer(0,0,$,ue,0,0,$,ue,ae,i.NEAREST),c===!0&&(Ie.length=0,Ie.push(i.COLOR_ATTACHMENT0+me),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Ie.push(_e),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ne)for(let me=0;me<S.length;me++){t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let U=n.get(S[me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,U,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&c){let S=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function lt(P){return Math.min(s.maxSamples,P.samples)}function we(P){let S=n.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function kt(P){let S=o.render.frame;h.get(P)!==S&&(h.set(P,S),P.update())}function Ge(P,S){let $=P.colorSpace,ue=P.format,ae=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||$!==ii&&$!==Ys&&(mt.getTransfer($)===Ct?(ue!==ki||ae!==pi)&&qe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",$)),S}function Ze(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(l.width=P.naturalWidth||P.width,l.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(l.width=P.displayWidth,l.height=P.displayHeight):(l.width=P.width,l.height=P.height),l}this.allocateTextureUnit=de,this.resetTextureUnits=ee,this.getTextureUnits=se,this.setTextureUnits=fe,this.setTexture2D=ge,this.setTexture2DArray=ve,this.setTexture3D=Ce,this.setTextureCube=Me,this.rebindTextures=en,this.setupRenderTarget=un,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=_n,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=we,this.dispose=H}function qT(i,e){function t(n,s=Ys){let r,o=mt.getTransfer(s);if(n===pi)return i.UNSIGNED_BYTE;if(n===oh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===ah)return i.UNSIGNED_SHORT_5_5_5_1;if(n===vf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===yf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===xf)return i.BYTE;if(n===_f)return i.SHORT;if(n===ra)return i.UNSIGNED_SHORT;if(n===rh)return i.INT;if(n===ji)return i.UNSIGNED_INT;if(n===Mi)return i.FLOAT;if(n===Zi)return i.HALF_FLOAT;if(n===bf)return i.ALPHA;if(n===Sf)return i.RGB;if(n===ki)return i.RGBA;if(n===Fs)return i.DEPTH_COMPONENT;if(n===$s)return i.DEPTH_STENCIL;if(n===lh)return i.RED;if(n===ch)return i.RED_INTEGER;if(n===vr)return i.RG;if(n===hh)return i.RG_INTEGER;if(n===uh)return i.RGBA_INTEGER;if(n===_l||n===vl||n===yl||n===bl)if(o===Ct)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===_l)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===vl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===yl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===bl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===_l)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===vl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===yl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===bl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===dh||n===fh||n===ph||n===mh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===dh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===fh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ph)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===mh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===gh||n===xh||n===_h||n===vh||n===yh||n===Sl||n===bh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===gh||n===xh)return o===Ct?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===_h)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===vh)return r.COMPRESSED_R11_EAC;if(n===yh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Sl)return r.COMPRESSED_RG11_EAC;if(n===bh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Sh||n===Mh||n===wh||n===Th||n===Eh||n===Ah||n===Rh||n===Ch||n===Ph||n===Ih||n===Lh||n===Nh||n===Dh||n===Oh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Sh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Mh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===wh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Th)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Eh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Ah)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Rh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ch)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Ph)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Ih)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Lh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Nh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Dh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Oh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Uh||n===Fh||n===kh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Uh)return o===Ct?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Fh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===kh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Bh||n===zh||n===Ml||n===Hh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Bh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===zh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ml)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Hh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Jr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var $T=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,YT=`
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

}`,Xf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new rl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ps({vertexShader:$T,fragmentShader:YT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Zt(new ol(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},qf=class extends Ki{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,u=null,d=null,f=null,p=null,v=typeof XRWebGLBinding<"u",g=new Xf,m={},y=t.getContextAttributes(),M=null,b=null,C=[],A=[],x=new je,E=null,k=null,D=new bn;D.viewport=new Dt;let L=new bn;L.viewport=new Dt;let W=[D,L],X=new th,O=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(te){let ge=C[te];return ge===void 0&&(ge=new Go,C[te]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(te){let ge=C[te];return ge===void 0&&(ge=new Go,C[te]=ge),ge.getGripSpace()},this.getHand=function(te){let ge=C[te];return ge===void 0&&(ge=new Go,C[te]=ge),ge.getHandSpace()};function Y(te){let ge=A.indexOf(te.inputSource);if(ge===-1)return;let ve=C[ge];ve!==void 0&&(ve.update(te.inputSource,te.frame,l||o),ve.dispatchEvent({type:te.type,data:te.inputSource}))}function B(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",ce);for(let te=0;te<C.length;te++){let ge=A[te];ge!==null&&(A[te]=null,C[te].disconnect(ge))}O=null,H=null,g.reset();for(let te in m)delete m[te];if(e.setRenderTarget(M),f=null,d=null,u=null,s=null,b=null,de.stop(),n.isPresenting=!1,e.setPixelRatio(E),e.setSize(x.width,x.height,!1),k!==null){let te=k.camera;te.fov=k.fov,te.zoom=k.zoom,te.updateProjectionMatrix(),k=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(te){r=te,n.isPresenting===!0&&qe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(te){a=te,n.isPresenting===!0&&qe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(te){l=te},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&v&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(te){if(s=te,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",B),s.addEventListener("inputsourceschange",ce),y.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(x),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Ce=null,Me=null;y.depth&&(Me=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=y.stencil?$s:Fs,Ce=y.stencil?Jr:ji);let $e={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer($e),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new Si(d.textureWidth,d.textureHeight,{format:ki,type:pi,depthTexture:new zs(d.textureWidth,d.textureHeight,Ce,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ve={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new Si(f.framebufferWidth,f.framebufferHeight,{format:ki,type:pi,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),de.setContext(s),de.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ce(te){for(let ge=0;ge<te.removed.length;ge++){let ve=te.removed[ge],Ce=A.indexOf(ve);Ce>=0&&(A[Ce]=null,C[Ce].disconnect(ve))}for(let ge=0;ge<te.added.length;ge++){let ve=te.added[ge],Ce=A.indexOf(ve);if(Ce===-1){for(let $e=0;$e<C.length;$e++)if($e>=A.length){A.push(ve),Ce=$e;break}else if(A[$e]===null){A[$e]=ve,Ce=$e;break}if(Ce===-1)break}let Me=C[Ce];Me&&Me.connect(ve)}}function Z(te,ge){ge===null?te.matrixWorld.copy(te.matrix):te.matrixWorld.multiplyMatrices(ge.matrixWorld,te.matrix),te.matrixWorldInverse.copy(te.matrixWorld).invert()}this.updateCamera=function(te){if(s===null)return;let ge=te.near,ve=te.far;g.texture!==null&&(g.depthNear>0&&(ge=g.depthNear),g.depthFar>0&&(ve=g.depthFar)),X.near=L.near=D.near=ge,X.far=L.far=D.far=ve,(O!==X.near||H!==X.far)&&(s.updateRenderState({depthNear:X.near,depthFar:X.far}),O=X.near,H=X.far),X.layers.mask=te.layers.mask|6,D.layers.mask=X.layers.mask&-5,L.layers.mask=X.layers.mask&-3;let Ce=te.parent,Me=X.cameras;Z(X,Ce);for(let $e=0;$e<Me.length;$e++)Z(Me[$e],Ce);X.projectionMatrix.copy(D.projectionMatrix),X.projectionMatrixInverse.copy(D.projectionMatrixInverse),k===null&&te.isPerspectiveCamera&&(k={camera:te,fov:te.fov,zoom:te.zoom}),ee(te,X,Ce)};function ee(te,ge,ve){ve===null?te.matrix.copy(ge.matrixWorld):(te.matrix.copy(ve.matrixWorld),te.matrix.invert(),te.matrix.multiply(ge.matrixWorld)),te.matrix.decompose(te.position,te.quaternion,te.scale),te.updateMatrixWorld(!0),te.projectionMatrix.copy(ge.projectionMatrix),te.projectionMatrixInverse.copy(ge.projectionMatrixInverse),te.isPerspectiveCamera&&(te.fov=Vr*2*Math.atan(1/te.projectionMatrix.elements[5]),te.zoom=1)}this.getCamera=function(){return X},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(te){c=te,d!==null&&(d.fixedFoveation=te),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=te)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(X)},this.getCameraTexture=function(te){return m[te]};let se=null;function fe(te,ge){if(h=ge.getViewerPose(l||o),p=ge,h!==null){let ve=h.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Ce=!1;ve.length!==X.cameras.length&&(X.cameras.length=0,Ce=!0);for(let We=0;We<ve.length;We++){let pt=ve[We],ut=null;if(f!==null)ut=f.getViewport(pt);else{let Yt=u.getViewSubImage(d,pt);ut=Yt.viewport,We===0&&(e.setRenderTargetTextures(b,Yt.colorTexture,Yt.depthStencilTexture),e.setRenderTarget(b))}let rt=W[We];rt===void 0&&(rt=new bn,rt.layers.enable(We),rt.viewport=new Dt,W[We]=rt),rt.matrix.fromArray(pt.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(pt.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ut.x,ut.y,ut.width,ut.height),We===0&&(X.matrix.copy(rt.matrix),X.matrix.decompose(X.position,X.quaternion,X.scale)),Ce===!0&&X.cameras.push(rt)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){u=n.getBinding();let We=u.getDepthInformation(ve[0]);We&&We.isValid&&We.texture&&g.init(We,s.renderState)}if(Me&&Me.includes("camera-access")&&v){e.state.unbindTexture(),u=n.getBinding();for(let We=0;We<ve.length;We++){let pt=ve[We].camera;if(pt){let ut=m[pt];ut||(ut=new rl,m[pt]=ut);let rt=u.getCameraImage(pt);ut.sourceTexture=rt}}}}for(let ve=0;ve<C.length;ve++){let Ce=A[ve],Me=C[ve];Ce!==null&&Me!==void 0&&Me.update(Ce,ge,l||o)}se&&se(te,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),p=null}let de=new ex;de.setAnimationLoop(fe),this.setAnimationLoop=function(te){se=te},this.dispose=function(){}}},KT=new ct,hx=new st;hx.set(-1,0,0,0,1,0,0,0,1);function jT(i,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,Nf(i)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,y,M,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),u(g,m)):m.isMeshPhongMaterial?(r(g,m),h(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),v(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?c(g,m,y,M):m.isSpriteMaterial?l(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===ri&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===ri&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let y=e.get(m),M=y.envMap,b=y.envMapRotation;M&&(g.envMap.value=M,g.envMapRotation.value.setFromMatrix4(KT.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(hx),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function c(g,m,y,M){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*y,g.scale.value=M*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function l(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function h(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function u(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,y){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ri&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function v(g,m){let y=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function ZT(i,e,t,n){let s={},r={};function o(y,M){let b=M.program;n.uniformBlockBinding(y,b,s[y.id])}function a(y,M){let b=s[y.id];b===void 0&&(p(y),b=c(y),s[y.id]=b,y.addEventListener("dispose",g));let C=M.program;n.updateUBOMapping(y,C);let A=e.render.frame;r[y.id]!==A&&(l(y),r[y.id]=A)}function c(y){let M=i.createBuffer(),b=y.__size,C=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,b,C),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function l(y){let M=s[y.id],b=y.uniforms,C=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let A=0,x=b.length;A<x;A++){let E=b[A];if(Array.isArray(E))for(let k=0,D=E.length;k<D;k++)h(E[k],A,k,C);else h(E,A,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,M,b,C){if(d(y,M,b,C)===!0){let A=y.__offset,x=y.value;if(Array.isArray(x)){let E=0;for(let k=0;k<x.length;k++){let D=x[k],L=v(D,!0);u(D,y.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,y.__data)}}function u(y,M,b){typeof y=="number"||typeof y=="boolean"?M[b]=y:y.isMatrix3?(M[b]=y.elements[0],M[b+1]=y.elements[1],M[b+2]=y.elements[2],M[b+3]=0,M[b+4]=y.elements[3],M[b+5]=y.elements[4],M[b+6]=y.elements[5],M[b+7]=0,M[b+8]=y.elements[6],M[b+9]=y.elements[7],M[b+10]=y.elements[8],M[b+11]=0):ArrayBuffer.isView(y)?M.set(y.subarray(0,M.length-b),b):y.toArray(M,b)}function d(y,M,b,C){let A=y.value,x=M+"_"+b;if(Array.isArray(A)){C[x]===void 0&&(C[x]=[]);let E=C[x],k=!1;for(let D=0;D<A.length;D++)f(A[D],E,D)===!0&&(k=!0);return k}return f(A,C,x)}function f(y,M,b){if(M[b]===void 0)return typeof y=="number"||typeof y=="boolean"?M[b]=y:ArrayBuffer.isView(y)?M[b]=y.slice():M[b]=y.clone(),!0;{let C=M[b];if(typeof y=="number"||typeof y=="boolean"){if(C!==y)return M[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(C.equals(y)===!1)return C.copy(y),!0}}return!1}function p(y){let M=y.uniforms,b=0,C=16;for(let x=0,E=M.length;x<E;x++){let k=Array.isArray(M[x])?M[x]:[M[x]];for(let D=0,L=k.length;D<L;D++){let W=k[D],X=Array.isArray(W.value)?W.value:[W.value],O=Array.isArray(M[x])||Array.isArray(W.value),H=b;for(let B=0,ce=X.length;B<ce;B++){let Z=X[B],ee=v(Z,O),se=b%C,fe=se%ee.boundary,de=se+fe;b+=fe,de!==0&&C-de<ee.storage&&(b+=C-de),B===0&&(H=b),b+=ee.storage}let Y=W.type==="int"?Int32Array:W.type==="uint"?Uint32Array:Float32Array;W.__data=new Y((b-H)/Float32Array.BYTES_PER_ELEMENT),W.__offset=H}}let A=b%C;return A>0&&(b+=C-A),y.__size=b,y.__cache={},this}function v(y,M){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?qe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):qe("WebGLRenderer: Unsupported uniform value type.",y),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(y){let M=y.target;M.removeEventListener("dispose",g),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function m(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:m}}var JT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ys=null;function QT(){return ys===null&&(ys=new $o(JT,16,16,vr,Zi),ys.name="DFG_LUT",ys.minFilter=Sn,ys.magFilter=Sn,ys.wrapS=Oi,ys.wrapT=Oi,ys.generateMipmaps=!1,ys.needsUpdate=!0),ys}var $h=class{constructor(e={}){let{canvas:t=T0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=pi}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let v=f,g=new Set([uh,hh,ch]),m=new Set([pi,ji,ra,Jr,oh,ah]),y=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,A=null,x=[],E=[],k=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=_s,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,L=!1,W=null,X=null,O=null,H=null;this._outputColorSpace=yn;let Y=0,B=0,ce=null,Z=-1,ee=null,se=new Dt,fe=new Dt,de=null,te=new Ke(0),ge=0,ve=t.width,Ce=t.height,Me=1,$e=null,at=null,We=new Dt(0,0,ve,Ce),pt=new Dt(0,0,ve,Ce),ut=!1,rt=new pr,Yt=new Vc,Vt=!1,hn=!1,Ot=new ct,Pn=new V,Mt=new Dt,_n={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function un(){return ce===null?Me:1}let F=n;function Ie(T,z){return t.getContext(T,z)}let Je,lt,we,kt,Ge,Ze,P,S,$,ue,ae,_e,ye,ne,re,me,U,oe,ie,Te,xe,Se,Xe;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),F===null){let z="webgl2";if(F=Ie(z,T),F===null)throw Ie(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(T){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),nt("WebGLRenderer: "+T.message),T}function et(){Je=new hw(F),Je.init(),xe=new qT(F,Je),lt=new QM(F,Je,e,xe),we=new WT(F,Je),lt.reversedDepthBuffer&&d&&we.buffers.depth.setReversed(!0),X=F.createFramebuffer(),O=F.createFramebuffer(),H=F.createFramebuffer(),kt=new fw(F),Ge=new PT,Ze=new XT(F,Je,we,Ge,lt,xe,kt),P=new cw(D),S=new mb(F),Se=new ZM(F,S),$=new uw(F,S,kt,Se),ue=new mw(F,$,S,Se,kt),oe=new pw(F,lt,Ze),re=new ew(Ge),ae=new CT(D,P,Je,lt,Se,re),_e=new jT(D,Ge),ye=new LT,ne=new kT(Je),U=new jM(D,P,we,ue,p,c),me=new GT(D,ue,lt),Xe=new ZT(F,kt,lt,we),ie=new JM(F,Je,kt),Te=new dw(F,Je,kt),kt.programs=ae.programs,D.capabilities=lt,D.extensions=Je,D.properties=Ge,D.renderLists=ye,D.shadowMap=me,D.state=we,D.info=kt}v!==pi&&(k=new xw(v,t.width,t.height,a,s,r));let he=new qf(D,F);this.xr=he,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let T=Je.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Je.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(T){T!==void 0&&(Me=T,this.setSize(ve,Ce,!1))},this.getSize=function(T){return T.set(ve,Ce)},this.setSize=function(T,z,Q=!0){if(he.isPresenting){qe("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=T,Ce=z,t.width=Math.floor(T*Me),t.height=Math.floor(z*Me),Q===!0&&(t.style.width=T+"px",t.style.height=z+"px"),k!==null&&k.setSize(t.width,t.height),this.setViewport(0,0,T,z)},this.getDrawingBufferSize=function(T){return T.set(ve*Me,Ce*Me).floor()},this.setDrawingBufferSize=function(T,z,Q){ve=T,Ce=z,Me=Q,t.width=Math.floor(T*Q),t.height=Math.floor(z*Q),this.setViewport(0,0,T,z)},this.setEffects=function(T){if(v===pi){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let z=0;z<T.length;z++)if(T[z].isOutputPass===!0){qe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(se)},this.getViewport=function(T){return T.copy(We)},this.setViewport=function(T,z,Q,K){T.isVector4?We.set(T.x,T.y,T.z,T.w):We.set(T,z,Q,K),we.viewport(se.copy(We).multiplyScalar(un()).round())},this.getScissor=function(T){return T.copy(pt)},this.setScissor=function(T,z,Q,K){T.isVector4?pt.set(T.x,T.y,T.z,T.w):pt.set(T,z,Q,K),we.scissor(fe.copy(pt).multiplyScalar(un()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(T){we.setScissorTest(ut=T)},this.setOpaqueSort=function(T){$e=T},this.setTransparentSort=function(T){at=T},this.getClearColor=function(T){return T.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(T=!0,z=!0,Q=!0){let K=0;if(T){let j=!1;if(ce!==null){let Ee=ce.texture.format;j=g.has(Ee)}if(j){let Ee=ce.texture.type,Le=m.has(Ee),Ae=U.getClearColor(),De=U.getClearAlpha(),Ve=Ae.r,it=Ae.g,_t=Ae.b;Le?(y[0]=Ve,y[1]=it,y[2]=_t,y[3]=De,F.clearBufferuiv(F.COLOR,0,y)):(M[0]=Ve,M[1]=it,M[2]=_t,M[3]=De,F.clearBufferiv(F.COLOR,0,M))}else K|=F.COLOR_BUFFER_BIT}z&&(K|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(K|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&F.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),W=T},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),U.dispose(),ye.dispose(),ne.dispose(),Ze.dispose(),Ge.dispose(),P.dispose(),ue.dispose(),$.dispose(),Se.dispose(),Xe.dispose(),ae.dispose(),he.dispose(),he.removeEventListener("sessionstart",ec),he.removeEventListener("sessionend",ss),Ts.stop()};function ze(T){T.preventDefault(),qa("WebGLRenderer: Context Lost."),L=!0}function tt(){qa("WebGLRenderer: Context Restored."),L=!1;let T=kt.autoReset,z=me.enabled,Q=me.autoUpdate,K=me.needsUpdate,j=me.type;et(),kt.autoReset=T,me.enabled=z,me.autoUpdate=Q,me.needsUpdate=K,me.type=j}function Pe(T){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function ht(T){let z=T.target;z.removeEventListener("dispose",ht),Gt(z)}function Gt(T){jn(T),Ge.remove(T)}function jn(T){let z=Ge.get(T).programs;z!==void 0&&(z.forEach(function(Q){ae.releaseProgram(Q)}),T.isShaderMaterial&&ae.releaseShaderCache(T))}this.renderBufferDirect=function(T,z,Q,K,j,Ee){z===null&&(z=_n);let Le=j.isMesh&&j.matrixWorld.determinantAffine()<0,Ae=Ca(T,z,Q,K,j);we.setMaterial(K,Le);let De=Q.index,Ve=1;if(K.wireframe===!0){if(De=$.getWireframeAttribute(Q),De===void 0)return;Ve=2}let it=Q.drawRange,_t=Q.attributes.position,He=it.start*Ve,vt=(it.start+it.count)*Ve;Ee!==null&&(He=Math.max(He,Ee.start*Ve),vt=Math.min(vt,(Ee.start+Ee.count)*Ve)),De!==null?(He=Math.max(He,0),vt=Math.min(vt,De.count)):_t!=null&&(He=Math.max(He,0),vt=Math.min(vt,_t.count));let Jt=vt-He;if(Jt<0||Jt===1/0)return;Se.setup(j,K,Ae,Q,De);let It,Lt=ie;if(De!==null&&(It=S.get(De),Lt=Te,Lt.setIndex(It)),j.isMesh)K.wireframe===!0?(we.setLineWidth(K.wireframeLinewidth*un()),Lt.setMode(F.LINES)):Lt.setMode(F.TRIANGLES);else if(j.isLine){let vn=K.linewidth;vn===void 0&&(vn=1),we.setLineWidth(vn*un()),j.isLineSegments?Lt.setMode(F.LINES):j.isLineLoop?Lt.setMode(F.LINE_LOOP):Lt.setMode(F.LINE_STRIP)}else j.isPoints?Lt.setMode(F.POINTS):j.isSprite&&Lt.setMode(F.TRIANGLES);if(j.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Lt.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let vn=j._multiDrawStarts,ke=j._multiDrawCounts,dn=j._multiDrawCount,bt=De?S.get(De).bytesPerElement:1,As=Ge.get(K).currentProgram.getUniforms();for(let fn=0;fn<dn;fn++)As.setValue(F,"_gl_DrawID",fn),Lt.render(vn[fn]/bt,ke[fn])}else if(j.isInstancedMesh)Lt.renderInstances(He,Jt,j.count);else if(Q.isInstancedBufferGeometry){let vn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,ke=Math.min(Q.instanceCount,vn);Lt.renderInstances(He,Jt,ke)}else Lt.render(He,Jt)};function Ea(T,z,Q,K){W!==null&&T.isNodeMaterial&&W.setObject(K,T),Vt===!0&&re.setState(T,Q,!1),T.transparent===!0&&T.side===fi&&T.forceSinglePass===!1?(T.side=ri,T.needsUpdate=!0,rs(T,z,K),T.side=xs,T.needsUpdate=!0,rs(T,z,K),T.side=fi):rs(T,z,K)}this.compile=function(T,z,Q=null){Q===null&&(Q=T),W!==null&&W.renderStart(T,z,Q),A=ne.get(Q),A.init(z),E.push(A),Q.traverseVisible(function(j){j.isLight&&j.layers.test(z.layers)&&(A.pushLight(j),j.castShadow&&A.pushShadow(j))}),T!==Q&&T.traverseVisible(function(j){j.isLight&&j.layers.test(z.layers)&&(A.pushLight(j),j.castShadow&&A.pushShadow(j))}),A.setupLights(),W!==null&&W.updateLights(A.state.lightsArray),hn=this.localClippingEnabled,Vt=re.init(this.clippingPlanes,hn),Vt===!0&&re.setGlobalState(this.clippingPlanes,z),W!==null&&me.render(A.state.shadowsArray,Q,z);let K=new Set;return T.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Ee=j.material;if(Ee)if(Array.isArray(Ee))for(let Le=0;Le<Ee.length;Le++){let Ae=Ee[Le];Ea(Ae,Q,z,j),K.add(Ae)}else Ea(Ee,Q,z,j),K.add(Ee)}),A=E.pop(),W!==null&&W.renderEnd(),K},this.compileAsync=function(T,z,Q=null){let K=this.compile(T,z,Q);return new Promise(j=>{function Ee(){if(K.forEach(function(Le){let De=Ge.get(Le).currentProgram;(De===void 0||De.isReady())&&K.delete(Le)}),K.size===0){j(T);return}setTimeout(Ee,10)}Je.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let lo=null;function ad(T){lo&&lo(T)}function ec(){Ts.stop()}function ss(){Ts.start()}let Ts=new ex;Ts.setAnimationLoop(ad),typeof self<"u"&&Ts.setContext(self),this.setAnimationLoop=function(T){lo=T,he.setAnimationLoop(T),T===null?Ts.stop():Ts.start()},he.addEventListener("sessionstart",ec),he.addEventListener("sessionend",ss),this.render=function(T,z){if(z!==void 0&&z.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;W!==null&&W.renderStart(T,z);let Q=he.enabled===!0&&he.isPresenting===!0,K=k!==null&&(ce===null||Q)&&k.begin(D,ce);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(z),z=he.getCamera()),T.isScene===!0&&T.onBeforeRender(D,T,z,ce),A=ne.get(T,E.length),A.init(z),A.state.textureUnits=Ze.getTextureUnits(),E.push(A),Ot.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Yt.setFromArrayCamera(z):rt.setFromProjectionMatrix(Ot,Ui,z.reversedDepth),hn=this.localClippingEnabled,Vt=re.init(this.clippingPlanes,hn),C=ye.get(T,x.length),C.init(),x.push(C),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Le=D.xr.getDepthSensingMesh();Le!==null&&Es(Le,z,-1/0,D.sortObjects)}Es(T,z,0,D.sortObjects),C.finish(),W!==null&&W.updateLights(A.state.lightsArray),D.sortObjects===!0&&C.sort($e,at),en=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,en&&U.addToRenderList(C,T),this.info.autoReset===!0&&this.info.reset(),Vt===!0&&re.beginShadows();let j=A.state.shadowsArray;if(me.render(j,T,z),Vt===!0&&re.endShadows(),(K&&k.hasRenderPass())===!1){let Le=C.opaque,Ae=C.transmissive;if(A.setupLights(),z.isArrayCamera){let De=z.cameras;if(Ae.length>0)for(let Ve=0,it=De.length;Ve<it;Ve++){let _t=De[Ve];Gi(Le,Ae,T,_t)}en&&U.render(T);for(let Ve=0,it=De.length;Ve<it;Ve++){let _t=De[Ve];Aa(C,T,_t,_t.viewport)}}else Ae.length>0&&Gi(Le,Ae,T,z),en&&U.render(T),Aa(C,T,z)}ce!==null&&B===0&&(Ze.updateMultisampleRenderTarget(ce),Ze.updateRenderTargetMipmap(ce)),K&&k.end(D),T.isScene===!0&&T.onAfterRender(D,T,z),Se.resetDefaultState(),Z=-1,ee=null,E.pop(),E.length>0?(A=E[E.length-1],Ze.setTextureUnits(A.state.textureUnits),Vt===!0&&re.setGlobalState(D.clippingPlanes,A.state.camera)):A=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,W!==null&&W.renderEnd()};function Es(T,z,Q,K){if(T.visible===!1)return;if(T.layers.test(z.layers)){if(T.isGroup)Q=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(z);else if(T.isLight)A.pushLight(T),T.castShadow&&A.pushShadow(T);else if(T.isSprite){let Le=z.isArrayCamera?Yt:rt;if(!T.frustumCulled||T.intersectsFrustum(Le)){K&&Mt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Ot);let Ae=ue.update(T),De=T.material;De.visible&&C.push(T,Ae,De,Q,Mt.z,null,z)}}else if(T.isMesh||T.isLine||T.isPoints){let Le=z.isArrayCamera?Yt:rt;if(!T.frustumCulled||T.intersectsFrustum(Le)){let Ae=ue.update(T),De=T.material;if(K&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),Mt.copy(T.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),Mt.copy(Ae.boundingSphere.center)),Mt.applyMatrix4(T.matrixWorld).applyMatrix4(Ot)),Array.isArray(De)){let Ve=Ae.groups;for(let it=0,_t=Ve.length;it<_t;it++){let He=Ve[it],vt=De[He.materialIndex];vt&&vt.visible&&C.push(T,Ae,vt,Q,Mt.z,He,z)}}else De.visible&&C.push(T,Ae,De,Q,Mt.z,null,z)}}}let Ee=T.children;for(let Le=0,Ae=Ee.length;Le<Ae;Le++)Es(Ee[Le],z,Q,K)}function Aa(T,z,Q,K){let{opaque:j,transmissive:Ee,transparent:Le}=T;A.setupLightsView(Q),Vt===!0&&re.setGlobalState(D.clippingPlanes,Q),K&&we.viewport(se.copy(K)),j.length>0&&tn(j,z,Q),Ee.length>0&&tn(Ee,z,Q),Le.length>0&&tn(Le,z,Q),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Gi(T,z,Q,K){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[K.id]===void 0){let He=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[K.id]=new Si(1,1,{generateMipmaps:!0,type:He?Zi:pi,minFilter:Fi,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:mt.workingColorSpace})}let Ee=A.state.transmissionRenderTarget[K.id],Le=K.viewport||se;Ee.setSize(Le.z*D.transmissionResolutionScale,Le.w*D.transmissionResolutionScale);let Ae=D.getRenderTarget(),De=D.getActiveCubeFace(),Ve=D.getActiveMipmapLevel();D.setRenderTarget(Ee),D.getClearColor(te),ge=D.getClearAlpha(),ge<1&&D.setClearColor(16777215,.5),D.clear(),en&&U.render(Q);let it=D.toneMapping;D.toneMapping=_s;let _t=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),A.setupLightsView(K),Vt===!0&&re.setGlobalState(D.clippingPlanes,K),tn(T,Q,K),Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee),Je.has("WEBGL_multisampled_render_to_texture")===!1){let He=!1;for(let vt=0,Jt=z.length;vt<Jt;vt++){let It=z[vt],{object:Lt,geometry:vn,material:ke,group:dn}=It;if(ke.side===fi&&Lt.layers.test(K.layers)){let bt=ke.side;ke.side=ri,ke.needsUpdate=!0,on(Lt,Q,K,vn,ke,dn),ke.side=bt,ke.needsUpdate=!0,He=!0}}He===!0&&(Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee))}D.setRenderTarget(Ae,De,Ve),D.setClearColor(te,ge),_t!==void 0&&(K.viewport=_t),D.toneMapping=it}function tn(T,z,Q){let K=z.isScene===!0?z.overrideMaterial:null;for(let j=0,Ee=T.length;j<Ee;j++){let Le=T[j],{object:Ae,geometry:De,group:Ve}=Le,it=Le.material;it.allowOverride===!0&&K!==null&&(it=K),Ae.layers.test(Q.layers)&&on(Ae,z,Q,De,it,Ve)}}function on(T,z,Q,K,j,Ee){W!==null&&j.isNodeMaterial&&W.setObject(T,j),T.onBeforeRender(D,z,Q,K,j,Ee),T.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),j.onBeforeRender(D,z,Q,K,T,Ee),j.transparent===!0&&j.side===fi&&j.forceSinglePass===!1?(j.side=ri,j.needsUpdate=!0,D.renderBufferDirect(Q,z,K,j,T,Ee),j.side=xs,j.needsUpdate=!0,D.renderBufferDirect(Q,z,K,j,T,Ee),j.side=fi):D.renderBufferDirect(Q,z,K,j,T,Ee),T.onAfterRender(D,z,Q,K,j,Ee)}function an(T){let z=0;for(let Q of T)Q.texture!==null&&z++;return z}function rs(T,z,Q){z.isScene!==!0&&(z=_n);let K=Ge.get(T),j=A.state.lights,Ee=A.state.shadowsArray,Le=j.state.version,Ae=ae.getParameters(T,j.state,Ee,z,Q,A.state.lightProbeGridArray),De=ae.getProgramCacheKey(Ae),Ve=K.programs;K.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?z.environment:null,K.fog=z.fog;let it=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;K.envMap=P.get(T.envMap||K.environment,it),K.envMapRotation=K.environment!==null&&T.envMap===null?z.environmentRotation:T.envMapRotation,Ve===void 0&&(T.addEventListener("dispose",ht),Ve=new Map,K.programs=Ve,K.programVariants=new Map);let _t=Ve.get(De);if(_t!==void 0){if(K.currentProgram===_t&&K.lightsStateVersion===Le)return Ra(T,Ae),_t}else Ae.uniforms=ae.getUniforms(T),W!==null&&T.isNodeMaterial&&W.build(T,Q,Ae),T.onBeforeCompile(Ae,D),_t=ae.acquireProgram(Ae,De),Ve.set(De,_t),K.uniforms=Ae.uniforms;let He=K.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(He.clippingPlanes=re.uniform),Ra(T,Ae),K.needsLights=tr(T),K.lightsStateVersion=Le,K.needsLights&&(He.ambientLightColor.value=j.state.ambient,He.lightProbe.value=j.state.probe,He.sunLights.value=j.state.sun,He.sunLightShadows.value=j.state.sunShadow,He.directionalLights.value=j.state.directional,He.directionalLightShadows.value=j.state.directionalShadow,He.spotLights.value=j.state.spot,He.spotLightShadows.value=j.state.spotShadow,He.rectAreaLights.value=j.state.rectArea,He.ltc_1.value=j.state.rectAreaLTC1,He.ltc_2.value=j.state.rectAreaLTC2,He.pointLights.value=j.state.point,He.pointLightShadows.value=j.state.pointShadow,He.hemisphereLights.value=j.state.hemi,He.sunShadowMatrix.value=j.state.sunShadowMatrix,He.sunShadowCascade.value=j.state.sunShadowCascade,He.directionalShadowMatrix.value=j.state.directionalShadowMatrix,He.spotLightMatrix.value=j.state.spotLightMatrix,He.spotLightMap.value=j.state.spotLightMap,He.pointShadowMatrix.value=j.state.pointShadowMatrix),K.numLightProbeGrids=an(A.state.lightProbeGridArray),K.currentProgram=_t,K.uniformsList=null,_t}function gi(T,z,Q,K,j){let Ee=Ge.get(T),Le=Ee.currentProgram.id+","+K+","+j,Ae=Ee.programVariants.get(Le);return Ae===void 0?(Ae=rs(T,z,Q),Ee.programVariants.set(Le,Ae)):(Ee.currentProgram=Ae,Ee.uniformsList=null,Ee.outputColorSpace=K,Ee.toneMapping=j),Ae}function er(T){if(T.uniformsList===null){let z=T.currentProgram.getUniforms();T.uniformsList=la.seqWithValue(z.seq,T.uniforms)}return T.uniformsList}function Ra(T,z){let Q=Ge.get(T);Q.outputColorSpace=z.outputColorSpace,Q.batching=z.batching,Q.batchingColor=z.batchingColor,Q.instancing=z.instancing,Q.instancingColor=z.instancingColor,Q.instancingMorph=z.instancingMorph,Q.skinning=z.skinning,Q.morphTargets=z.morphTargets,Q.morphNormals=z.morphNormals,Q.morphColors=z.morphColors,Q.morphTargetsCount=z.morphTargetsCount,Q.numClippingPlanes=z.numClippingPlanes,Q.numIntersection=z.numClipIntersection,Q.vertexAlphas=z.vertexAlphas,Q.vertexTangents=z.vertexTangents,Q.toneMapping=z.toneMapping}function Ca(T,z,Q,K,j){z.isScene!==!0&&(z=_n),Ze.resetTextureUnits();let Ee=z.fog,Le=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?z.environment:null,Ae=ce===null?D.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:mt.workingColorSpace,De=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Ve=P.get(K.envMap||Le,De),it=K.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,_t=!!Q.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),He=!!Q.morphAttributes.position,vt=!!Q.morphAttributes.normal,Jt=!!Q.morphAttributes.color,It=_s;K.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(It=D.toneMapping);let Lt=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,vn=Lt!==void 0?Lt.length:0,ke=Ge.get(K),dn=A.state.lights;if(Vt===!0&&(hn===!0||T!==ee)){let Nt=T===ee&&K.id===Z;re.setState(K,T,Nt)}let bt=!1,As=!1;K.version===ke.__version?ke.needsLights&&ke.lightsStateVersion!==dn.state.version||j.isBatchedMesh&&ke.batching===!1||!j.isBatchedMesh&&ke.batching===!0||j.isBatchedMesh&&ke.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&ke.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&ke.instancing===!1||!j.isInstancedMesh&&ke.instancing===!0||j.isSkinnedMesh&&ke.skinning===!1||!j.isSkinnedMesh&&ke.skinning===!0||j.isInstancedMesh&&ke.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&ke.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&ke.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&ke.instancingMorph===!1&&j.morphTexture!==null||ke.envMap!==Ve||K.fog===!0&&ke.fog!==Ee||ke.numClippingPlanes!==void 0&&(ke.numClippingPlanes!==re.numPlanes||ke.numIntersection!==re.numIntersection)||ke.vertexAlphas!==it||ke.vertexTangents!==_t||ke.morphTargets!==He||ke.morphNormals!==vt||ke.morphColors!==Jt||ke.morphTargetsCount!==vn||ke.numLightProbeGrids!==an(A.state.lightProbeGridArray)?bt=!0:(ke.outputColorSpace!==Ae||ke.toneMapping!==It)&&(As=!0):(bt=!0,ke.__version=K.version);let fn=ke.currentProgram;(bt===!0||As===!0)&&(fn=As===!0?gi(K,z,j,Ae,It):rs(K,z,j),W&&K.isNodeMaterial&&W.onUpdateProgram(K,fn,ke));let uo=!1,os=!1,Rs=!1,dt=fn.getUniforms(),nn=ke.uniforms;if(we.useProgram(fn.program)&&(uo=!0,os=!0,Rs=!0),K.id!==Z&&(Z=K.id,os=!0),uo||ee!==T){we.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),dt.setValue(F,"projectionMatrix",T.projectionMatrix),dt.setValue(F,"viewMatrix",T.matrixWorldInverse);let pn=dt.map.cameraPosition;pn!==void 0&&pn.setValue(F,Pn.setFromMatrixPosition(T.matrixWorld)),lt.logarithmicDepthBuffer&&dt.setValue(F,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&dt.setValue(F,"isOrthographic",T.isOrthographicCamera===!0),ee!==T&&(ee=T,os=!0,Rs=!0)}if(ke.needsLights&&(dn.state.sunShadowMap.length>0&&dt.setValue(F,"sunShadowMap",dn.state.sunShadowMap,Ze),dn.state.directionalShadowMap.length>0&&dt.setValue(F,"directionalShadowMap",dn.state.directionalShadowMap,Ze),dn.state.spotShadowMap.length>0&&dt.setValue(F,"spotShadowMap",dn.state.spotShadowMap,Ze),dn.state.pointShadowMap.length>0&&dt.setValue(F,"pointShadowMap",dn.state.pointShadowMap,Ze)),j.isSkinnedMesh){dt.setOptional(F,j,"bindMatrix"),dt.setOptional(F,j,"bindMatrixInverse");let Nt=j.skeleton;Nt&&(Nt.boneTexture===null&&Nt.computeBoneTexture(),dt.setValue(F,"boneTexture",Nt.boneTexture,Ze))}j.isBatchedMesh&&(dt.setOptional(F,j,"batchingTexture"),dt.setValue(F,"batchingTexture",j._matricesTexture,Ze),dt.setOptional(F,j,"batchingIdTexture"),dt.setValue(F,"batchingIdTexture",j._indirectTexture,Ze),dt.setOptional(F,j,"batchingColorTexture"),j._colorsTexture!==null&&dt.setValue(F,"batchingColorTexture",j._colorsTexture,Ze));let Zn=Q.morphAttributes;if((Zn.position!==void 0||Zn.normal!==void 0||Zn.color!==void 0)&&oe.update(j,Q,fn),(os||ke.receiveShadow!==j.receiveShadow)&&(ke.receiveShadow=j.receiveShadow,dt.setValue(F,"receiveShadow",j.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&z.environment!==null&&(nn.envMapIntensity.value=z.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=QT()),os){if(dt.setValue(F,"toneMappingExposure",D.toneMappingExposure),ke.needsLights&&co(nn,Rs),Ee&&K.fog===!0&&_e.refreshFogUniforms(nn,Ee),_e.refreshMaterialUniforms(nn,K,Me,Ce,A.state.transmissionRenderTarget[T.id]),ke.needsLights&&ke.numLightProbeGrids>0){let Nt=b,pn=0;for(let Xn of A.state.lightProbeGridArray)Xn.texture!==null&&(Nt.textures[pn]=Xn.texture,Nt.min[pn]=Xn.boundingBox.min,Nt.max[pn]=Xn.boundingBox.max,Nt.resolution[pn]=Xn.resolution,pn++);for(let Xn in Nt)Nt[Xn].length=pn;nn.probesSH.value=Nt.textures,nn.probesMin.value=Nt.min,nn.probesMax.value=Nt.max,nn.probesResolution.value=Nt.resolution}la.upload(F,er(ke),nn,Ze)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(la.upload(F,er(ke),nn,Ze),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&dt.setValue(F,"center",j.center),dt.setValue(F,"modelViewMatrix",j.modelViewMatrix),dt.setValue(F,"normalMatrix",j.normalMatrix),dt.setValue(F,"modelMatrix",j.matrixWorld),K.uniformsGroups!==void 0){let Nt=K.uniformsGroups;for(let pn=0,Xn=Nt.length;pn<Xn;pn++){let tc=Nt[pn];Xe.update(tc,fn),Xe.bind(tc,fn)}}return fn}function co(T,z){T.ambientLightColor.needsUpdate=z,T.lightProbe.needsUpdate=z,T.sunLights.needsUpdate=z,T.sunLightShadows.needsUpdate=z,T.directionalLights.needsUpdate=z,T.directionalLightShadows.needsUpdate=z,T.pointLights.needsUpdate=z,T.pointLightShadows.needsUpdate=z,T.spotLights.needsUpdate=z,T.spotLightShadows.needsUpdate=z,T.rectAreaLights.needsUpdate=z,T.hemisphereLights.needsUpdate=z}function tr(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(T,z,Q){let K=Ge.get(T);K.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Ge.get(T.texture).__webglTexture=z,Ge.get(T.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:Q,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,z){let Q=Ge.get(T);Q.__webglFramebuffer=z,Q.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(T,z=0,Q=0){ce=T,Y=z,B=Q;let K=null,j=!1,Ee=!1;if(T){let Ae=Ge.get(T);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(F.FRAMEBUFFER,Ae.__webglFramebuffer),se.copy(T.viewport),fe.copy(T.scissor),de=T.scissorTest,we.viewport(se),we.scissor(fe),we.setScissorTest(de),Z=-1;return}else if(Ae.__webglFramebuffer===void 0)Ze.setupRenderTarget(T);else if(Ae.__hasExternalTextures)Ze.rebindTextures(T,Ge.get(T.texture).__webglTexture,Ge.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let it=T.depthTexture;if(Ae.__boundDepthTexture!==it){if(it!==null&&Ge.has(it)&&(T.width!==it.image.width||T.height!==it.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(T)}}let De=T.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ee=!0);let Ve=Ge.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Ve[z])?K=Ve[z][Q]:K=Ve[z],j=!0):T.samples>0&&Ze.useMultisampledRTT(T)===!1?K=Ge.get(T).__webglMultisampledFramebuffer:Array.isArray(Ve)?K=Ve[Q]:K=Ve,se.copy(T.viewport),fe.copy(T.scissor),de=T.scissorTest}else se.copy(We).multiplyScalar(Me).floor(),fe.copy(pt).multiplyScalar(Me).floor(),de=ut;if(Q!==0&&(K=X),we.bindFramebuffer(F.FRAMEBUFFER,K)&&we.drawBuffers(T,K),we.viewport(se),we.scissor(fe),we.setScissorTest(de),j){let Ae=Ge.get(T.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ae.__webglTexture,Q)}else if(Ee){let Ae=z;for(let De=0;De<T.textures.length;De++){let Ve=Ge.get(T.textures[De]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+De,Ve.__webglTexture,Q,Ae)}}else if(T!==null&&Q!==0){let Ae=Ge.get(T.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ae.__webglTexture,Q)}Z=-1};function ho(T){let z=Ge.get(T);return(z.__readFormat!==T.format||z.__readType!==T.type)&&(z.__readFormat=T.format,z.__readType=T.type,z.__formatReadable=lt.textureFormatReadable(T.format),z.__typeReadable=lt.textureTypeReadable(T.type)),z}this.readRenderTargetPixels=function(T,z,Q,K,j,Ee,Le,Ae=0){if(!(T&&T.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=Ge.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De){we.bindFramebuffer(F.FRAMEBUFFER,De);try{let Ve=T.textures[Ae],it=Ve.format,_t=Ve.type;T.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ae);let He=ho(Ve);if(He.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(He.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=T.width-K&&Q>=0&&Q<=T.height-j&&F.readPixels(z,Q,K,j,xe.convert(it),xe.convert(_t),Ee)}finally{let Ve=ce!==null?Ge.get(ce).__webglFramebuffer:null;we.bindFramebuffer(F.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(T,z,Q,K,j,Ee,Le,Ae=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=Ge.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De)if(z>=0&&z<=T.width-K&&Q>=0&&Q<=T.height-j){we.bindFramebuffer(F.FRAMEBUFFER,De);let Ve=T.textures[Ae],it=Ve.format,_t=Ve.type;T.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ae);let He=ho(Ve);if(He.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(He.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let vt=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,vt),F.bufferData(F.PIXEL_PACK_BUFFER,Ee.byteLength,F.STREAM_READ),F.readPixels(z,Q,K,j,xe.convert(it),xe.convert(_t),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Jt=ce!==null?Ge.get(ce).__webglFramebuffer:null;we.bindFramebuffer(F.FRAMEBUFFER,Jt);let It=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await A0(F,It,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,vt),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Ee),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(vt),F.deleteSync(It),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,z=null,Q=0){let K=Math.pow(2,-Q),j=Math.floor(T.image.width*K),Ee=Math.floor(T.image.height*K),Le=z!==null?z.x:0,Ae=z!==null?z.y:0;Ze.setTexture2D(T,0),F.copyTexSubImage2D(F.TEXTURE_2D,Q,0,0,Le,Ae,j,Ee),we.unbindTexture()},this.copyTextureToTexture=function(T,z,Q=null,K=null,j=0,Ee=0){let Le,Ae,De,Ve,it,_t,He,vt,Jt,It=T.isCompressedTexture?T.mipmaps[Ee]:T.image;if(Q!==null)Le=Q.max.x-Q.min.x,Ae=Q.max.y-Q.min.y,De=Q.isBox3?Q.max.z-Q.min.z:1,Ve=Q.min.x,it=Q.min.y,_t=Q.isBox3?Q.min.z:0;else{let dt=Math.pow(2,-j);Le=Math.floor(It.width*dt),Ae=Math.floor(It.height*dt),T.isDataArrayTexture?De=It.depth:T.isData3DTexture?De=Math.floor(It.depth*dt):De=1,Ve=0,it=0,_t=0}K!==null?(He=K.x,vt=K.y,Jt=K.z):(He=0,vt=0,Jt=0);let Lt=xe.convert(z.format),vn=xe.convert(z.type),ke;z.isData3DTexture?(Ze.setTexture3D(z,0),ke=F.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Ze.setTexture2DArray(z,0),ke=F.TEXTURE_2D_ARRAY):(Ze.setTexture2D(z,0),ke=F.TEXTURE_2D),we.activeTexture(F.TEXTURE0),we.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,z.flipY),we.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),we.pixelStorei(F.UNPACK_ALIGNMENT,z.unpackAlignment);let dn=we.getParameter(F.UNPACK_ROW_LENGTH),bt=we.getParameter(F.UNPACK_IMAGE_HEIGHT),As=we.getParameter(F.UNPACK_SKIP_PIXELS),fn=we.getParameter(F.UNPACK_SKIP_ROWS),uo=we.getParameter(F.UNPACK_SKIP_IMAGES);we.pixelStorei(F.UNPACK_ROW_LENGTH,It.width),we.pixelStorei(F.UNPACK_IMAGE_HEIGHT,It.height),we.pixelStorei(F.UNPACK_SKIP_PIXELS,Ve),we.pixelStorei(F.UNPACK_SKIP_ROWS,it),we.pixelStorei(F.UNPACK_SKIP_IMAGES,_t);let os=T.isDataArrayTexture||T.isData3DTexture,Rs=z.isDataArrayTexture||z.isData3DTexture;if(T.isDepthTexture){let dt=Ge.get(T),nn=Ge.get(z),Zn=Ge.get(dt.__renderTarget),Nt=Ge.get(nn.__renderTarget);we.bindFramebuffer(F.READ_FRAMEBUFFER,Zn.__webglFramebuffer),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let pn=0;pn<De;pn++)os&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ge.get(T).__webglTexture,j,_t+pn),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ge.get(z).__webglTexture,Ee,Jt+pn)),F.blitFramebuffer(Ve,it,Ve+Le,it+Ae,He,vt,He+Le,vt+Ae,F.DEPTH_BUFFER_BIT,F.NEAREST);we.bindFramebuffer(F.READ_FRAMEBUFFER,null),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(j!==0||T.isRenderTargetTexture||Ge.has(T)){let dt=Ge.get(T),nn=Ge.get(z);we.bindFramebuffer(F.READ_FRAMEBUFFER,O),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,H);for(let Zn=0;Zn<De;Zn++)os?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,dt.__webglTexture,j,_t+Zn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,dt.__webglTexture,j),Rs?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,nn.__webglTexture,Ee,Jt+Zn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,nn.__webglTexture,Ee),j!==0?F.blitFramebuffer(Ve,it,Ve+Le,it+Ae,He,vt,He+Le,vt+Ae,F.COLOR_BUFFER_BIT,F.NEAREST):Rs?F.copyTexSubImage3D(ke,Ee,He,vt,Jt+Zn,Ve,it,Le,Ae):F.copyTexSubImage2D(ke,Ee,He,vt,Ve,it,Le,Ae);we.bindFramebuffer(F.READ_FRAMEBUFFER,null),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else Rs?T.isDataTexture||T.isData3DTexture?F.texSubImage3D(ke,Ee,He,vt,Jt,Le,Ae,De,Lt,vn,It.data):z.isCompressedArrayTexture?F.compressedTexSubImage3D(ke,Ee,He,vt,Jt,Le,Ae,De,Lt,It.data):F.texSubImage3D(ke,Ee,He,vt,Jt,Le,Ae,De,Lt,vn,It):T.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Ee,He,vt,Le,Ae,Lt,vn,It.data):T.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Ee,He,vt,It.width,It.height,Lt,It.data):F.texSubImage2D(F.TEXTURE_2D,Ee,He,vt,Le,Ae,Lt,vn,It);we.pixelStorei(F.UNPACK_ROW_LENGTH,dn),we.pixelStorei(F.UNPACK_IMAGE_HEIGHT,bt),we.pixelStorei(F.UNPACK_SKIP_PIXELS,As),we.pixelStorei(F.UNPACK_SKIP_ROWS,fn),we.pixelStorei(F.UNPACK_SKIP_IMAGES,uo),Ee===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&F.generateMipmap(ke),we.unbindTexture()},this.initRenderTarget=function(T){Ge.get(T).__webglFramebuffer===void 0&&Ze.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Ze.setTextureCube(T,0):T.isData3DTexture?Ze.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Ze.setTexture2DArray(T,0):Ze.setTexture2D(T,0),we.unbindTexture()},this.resetState=function(){Y=0,B=0,ce=null,we.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ui}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=mt._getUnpackColorSpace()}};var ux={type:"change"},Yf={type:"start"},fx={type:"end"},jh=new fs,dx=new zn,eE=Math.cos(70*aa.DEG2RAD),Tn=new V,mi=2*Math.PI,At={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},$f=1e-6,Zh=class extends gl{constructor(e,t=null){super(e,t),this.state=At.NONE,this.target=new V,this.cursor=new V,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:xr.ROTATE,MIDDLE:xr.DOLLY,RIGHT:xr.PAN},this.touches={ONE:_r.ROTATE,TWO:_r.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new V,this._lastQuaternion=new Fn,this._lastTargetPosition=new V,this._quat=new Fn().setFromUnitVectors(e.up,new V(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ea,this._sphericalDelta=new ea,this._scale=1,this._panOffset=new V,this._rotateStart=new je,this._rotateEnd=new je,this._rotateDelta=new je,this._panStart=new je,this._panEnd=new je,this._panDelta=new je,this._dollyStart=new je,this._dollyEnd=new je,this._dollyDelta=new je,this._dollyDirection=new V,this._mouse=new je,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=nE.bind(this),this._onPointerDown=tE.bind(this),this._onPointerUp=iE.bind(this),this._onContextMenu=hE.bind(this),this._onMouseWheel=oE.bind(this),this._onKeyDown=aE.bind(this),this._onTouchStart=lE.bind(this),this._onTouchMove=cE.bind(this),this._onMouseDown=sE.bind(this),this._onMouseMove=rE.bind(this),this._interceptControlDown=uE.bind(this),this._interceptControlUp=dE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=At.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(ux),this.update(),this.state=At.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Tn.copy(t).sub(this.target),Tn.applyQuaternion(this._quat),this._spherical.setFromVector3(Tn),this.autoRotate&&this.state===At.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=mi:n>Math.PI&&(n-=mi),s<-Math.PI?s+=mi:s>Math.PI&&(s-=mi),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Tn.setFromSpherical(this._spherical),Tn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Tn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Tn.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new V(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new V(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=Tn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(jh.origin.copy(this.object.position),jh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(jh.direction))<eE?this.object.lookAt(this.target):(dx.setFromNormalAndCoplanarPoint(this.object.up,this.target),jh.intersectPlane(dx,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>$f||8*(1-this._lastQuaternion.dot(this.object.quaternion))>$f||this._lastTargetPosition.distanceToSquared(this.target)>$f?(this.dispatchEvent(ux),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?mi/60*this.autoRotateSpeed*e:mi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Tn.setFromMatrixColumn(t,0),Tn.multiplyScalar(-e),this._panOffset.add(Tn)}_panUp(e,t){this.screenSpacePanning===!0?Tn.setFromMatrixColumn(t,1):(Tn.setFromMatrixColumn(t,0),Tn.crossVectors(this.object.up,Tn)),Tn.multiplyScalar(e),this._panOffset.add(Tn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Tn.copy(s).sub(this.target);let r=Tn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(mi*this._rotateDelta.x/t.clientHeight),this._rotateUp(mi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(mi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-mi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(mi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-mi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(mi*this._rotateDelta.x/t.clientHeight),this._rotateUp(mi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new je,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function tE(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function nE(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function iE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(fx),this.state=At.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function sE(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case xr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=At.DOLLY;break;case xr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}break;case xr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=At.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=At.PAN}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(Yf)}function rE(i){switch(this.state){case At.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case At.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case At.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function oE(i){this.enabled===!1||this.enableZoom===!1||this.state!==At.NONE||(i.preventDefault(),this.dispatchEvent(Yf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(fx))}function aE(i){this.enabled!==!1&&this._handleKeyDown(i)}function lE(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case _r.ROTATE:if(this.enableRotate===!1){this.state=At.NONE;break}this._handleTouchStartRotate(i),this.state=At.TOUCH_ROTATE;break;case _r.PAN:if(this.enablePan===!1){this.state=At.NONE;break}this._handleTouchStartPan(i),this.state=At.TOUCH_PAN;break;default:this.state=At.NONE}break;case 2:switch(this.touches.TWO){case _r.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=At.TOUCH_DOLLY_PAN;break;case _r.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=At.TOUCH_DOLLY_ROTATE;break;default:this.state=At.NONE}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(Yf)}function cE(i){switch(this._trackPointer(i),this.state){case At.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case At.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case At.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case At.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=At.NONE}}function hE(i){this.enabled!==!1&&i.preventDefault()}function uE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function dE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Kf(i,e){if(e===Mf)return console.warn("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Geometry already defined as triangles."),i;if(e===oa||e===wl){let t=i.getIndex();if(t===null){let r=[],o=i.getAttribute("position");if(o!==void 0){for(let a=0;a<o.count;a++)r.push(a);i.setIndex(r),t=i.getIndex()}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Undefined position attribute. Processing not possible."),i}let n=t.count-2,s=[];if(e===oa)for(let r=1;r<=n;r++)s.push(t.getX(0)),s.push(t.getX(r)),s.push(t.getX(r+1));else for(let r=0;r<n;r++)r%2===0?(s.push(t.getX(r)),s.push(t.getX(r+1)),s.push(t.getX(r+2))):(s.push(t.getX(r+2)),s.push(t.getX(r+1)),s.push(t.getX(r)));return s.length/3!==n&&console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unable to generate correct amount of triangles."),i.setIndex(s),i.clearGroups(),i}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unknown draw mode:",e),i}function px(i){let e=new Map,t=new Map,n=i.clone();return mx(i,n,function(s,r){e.set(r,s),t.set(s,r)}),n.traverse(function(s){if(!s.isSkinnedMesh)return;let r=s,o=e.get(s),a=o.skeleton.bones;r.skeleton=o.skeleton.clone(),r.bindMatrix.copy(o.bindMatrix),r.skeleton.bones=a.map(function(c){return t.get(c)}),r.bind(r.skeleton,r.bindMatrix)}),n}function mx(i,e,t){t(i,e);for(let n=0;n<i.children.length;n++)mx(i.children[n],e.children[n],t)}var Jh=class extends gs{constructor(e){super(e),this.dracoLoader=null,this.ktx2Loader=null,this.meshoptDecoder=null,this.pluginCallbacks=[],this.register(function(t){return new np(t)}),this.register(function(t){return new ip(t)}),this.register(function(t){return new sp(t)}),this.register(function(t){return new fp(t)}),this.register(function(t){return new pp(t)}),this.register(function(t){return new mp(t)}),this.register(function(t){return new op(t)}),this.register(function(t){return new ap(t)}),this.register(function(t){return new lp(t)}),this.register(function(t){return new cp(t)}),this.register(function(t){return new tp(t)}),this.register(function(t){return new hp(t)}),this.register(function(t){return new rp(t)}),this.register(function(t){return new dp(t)}),this.register(function(t){return new up(t)}),this.register(function(t){return new Qf(t)}),this.register(function(t){return new Qh(t,xt.EXT_MESHOPT_COMPRESSION)}),this.register(function(t){return new Qh(t,xt.KHR_MESHOPT_COMPRESSION)}),this.register(function(t){return new gp(t)})}load(e,t,n,s){let r=this,o;if(this.resourcePath!=="")o=this.resourcePath;else if(this.path!==""){let l=qs.extractUrlBase(e);o=qs.resolveURL(l,this.path)}else o=qs.extractUrlBase(e);this.manager.itemStart(e);let a=function(l){s?s(l):console.error(l),r.manager.itemError(e),r.manager.itemEnd(e)},c=new Zo(this.manager);c.setPriority(this.priority),c.setCache(this.cache),c.setPath(this.path),c.setResponseType("arraybuffer"),c.setRequestHeader(this.requestHeader),c.setWithCredentials(this.withCredentials),c.load(e,function(l){try{r.parse(l,o,function(h){t(h),r.manager.itemEnd(e)},a)}catch(h){a(h)}},n,a)}setDRACOLoader(e){return this.dracoLoader=e,this}setKTX2Loader(e){return this.ktx2Loader=e,this}setMeshoptDecoder(e){return this.meshoptDecoder=e,this}register(e){return this.pluginCallbacks.indexOf(e)===-1&&this.pluginCallbacks.push(e),this}unregister(e){return this.pluginCallbacks.indexOf(e)!==-1&&this.pluginCallbacks.splice(this.pluginCallbacks.indexOf(e),1),this}parse(e,t,n,s){let r,o={},a={},c=new TextDecoder;if(typeof e=="string")r=JSON.parse(e);else if(e instanceof ArrayBuffer)if(c.decode(new Uint8Array(e,0,4))===yx){try{o[xt.KHR_BINARY_GLTF]=new xp(e)}catch(u){s&&s(u);return}r=JSON.parse(o[xt.KHR_BINARY_GLTF].content)}else r=JSON.parse(c.decode(e));else r=e;if(r.asset===void 0||r.asset.version[0]<2){s&&s(new Error("THREE.GLTFLoader: Unsupported asset. glTF versions >=2.0 are supported."));return}let l=new wp(r,{path:t||this.resourcePath||"",crossOrigin:this.crossOrigin,priority:this.priority,cache:this.cache,withCredentials:this.withCredentials,requestHeader:this.requestHeader,manager:this.manager,ktx2Loader:this.ktx2Loader,meshoptDecoder:this.meshoptDecoder});l.fileLoader.setRequestHeader(this.requestHeader);for(let h=0;h<this.pluginCallbacks.length;h++){let u=this.pluginCallbacks[h](l);u.name||console.error("THREE.GLTFLoader: Invalid plugin found: missing name"),a[u.name]=u,o[u.name]=!0}if(r.extensionsUsed)for(let h=0;h<r.extensionsUsed.length;++h){let u=r.extensionsUsed[h],d=r.extensionsRequired||[];switch(u){case xt.KHR_MATERIALS_UNLIT:o[u]=new ep;break;case xt.KHR_DRACO_MESH_COMPRESSION:o[u]=new _p(r,this.dracoLoader);break;case xt.KHR_TEXTURE_TRANSFORM:o[u]=new vp;break;case xt.KHR_MESH_QUANTIZATION:o[u]=new yp;break;default:d.indexOf(u)>=0&&a[u]===void 0&&console.warn('THREE.GLTFLoader: Unknown extension "'+u+'".')}}l.setExtensions(o),l.setPlugins(a),l.parse(n,s)}parseAsync(e,t){let n=this;return new Promise(function(s,r){n.parse(e,t,s,r)})}};function fE(){let i={};return{get:function(e){return i[e]},add:function(e,t){i[e]=t},remove:function(e){delete i[e]},removeAll:function(){i={}}}}function Qt(i,e,t){let n=i.json.materials[e];return n.extensions&&n.extensions[t]?n.extensions[t]:null}var xt={KHR_BINARY_GLTF:"KHR_binary_glTF",KHR_DRACO_MESH_COMPRESSION:"KHR_draco_mesh_compression",KHR_LIGHTS_PUNCTUAL:"KHR_lights_punctual",KHR_MATERIALS_CLEARCOAT:"KHR_materials_clearcoat",KHR_MATERIALS_DIFFUSE_ROUGHNESS:"KHR_materials_diffuse_roughness",KHR_MATERIALS_DISPERSION:"KHR_materials_dispersion",KHR_MATERIALS_IOR:"KHR_materials_ior",KHR_MATERIALS_SHEEN:"KHR_materials_sheen",KHR_MATERIALS_SPECULAR:"KHR_materials_specular",KHR_MATERIALS_TRANSMISSION:"KHR_materials_transmission",KHR_MATERIALS_IRIDESCENCE:"KHR_materials_iridescence",KHR_MATERIALS_ANISOTROPY:"KHR_materials_anisotropy",KHR_MATERIALS_UNLIT:"KHR_materials_unlit",KHR_MATERIALS_VOLUME:"KHR_materials_volume",KHR_TEXTURE_BASISU:"KHR_texture_basisu",KHR_TEXTURE_TRANSFORM:"KHR_texture_transform",KHR_MESH_QUANTIZATION:"KHR_mesh_quantization",KHR_MATERIALS_EMISSIVE_STRENGTH:"KHR_materials_emissive_strength",EXT_MATERIALS_BUMP:"EXT_materials_bump",EXT_TEXTURE_WEBP:"EXT_texture_webp",EXT_TEXTURE_AVIF:"EXT_texture_avif",EXT_MESHOPT_COMPRESSION:"EXT_meshopt_compression",KHR_MESHOPT_COMPRESSION:"KHR_meshopt_compression",EXT_MESH_GPU_INSTANCING:"EXT_mesh_gpu_instancing"},Qf=class{constructor(e){this.parser=e,this.name=xt.KHR_LIGHTS_PUNCTUAL,this.cache={refs:{},uses:{}}}_markDefs(){let e=this.parser,t=this.parser.json.nodes||[];for(let n=0,s=t.length;n<s;n++){let r=t[n];r.extensions&&r.extensions[this.name]&&r.extensions[this.name].light!==void 0&&e._addNodeRef(this.cache,r.extensions[this.name].light)}}_loadLight(e){let t=this.parser,n="light:"+e,s=t.cache.get(n);if(s)return s;let r=t.json,c=((r.extensions&&r.extensions[this.name]||{}).lights||[])[e],l,h=new Ke(16777215);c.color!==void 0&&h.setRGB(c.color[0],c.color[1],c.color[2],ii);let u=c.range!==void 0?c.range:0;switch(c.type){case"directional":l=new qr(h),l.target.position.set(0,0,-1),l.add(l.target);break;case"point":l=new fl(h),l.distance=u;break;case"spot":l=new dl(h),l.distance=u,c.spot=c.spot||{},c.spot.innerConeAngle=c.spot.innerConeAngle!==void 0?c.spot.innerConeAngle:0,c.spot.outerConeAngle=c.spot.outerConeAngle!==void 0?c.spot.outerConeAngle:Math.PI/4,l.angle=c.spot.outerConeAngle,l.penumbra=1-c.spot.innerConeAngle/c.spot.outerConeAngle,l.target.position.set(0,0,-1),l.add(l.target);break;default:throw new Error("THREE.GLTFLoader: Unexpected light type: "+c.type)}return l.position.set(0,0,0),Ss(l,c),c.intensity!==void 0&&(l.intensity=c.intensity),l.name=t.createUniqueName(c.name||"light_"+e),s=Promise.resolve(l),t.cache.add(n,s),s}getDependency(e,t){if(e==="light")return this._loadLight(t)}createNodeAttachment(e){let t=this,n=this.parser,r=n.json.nodes[e],a=(r.extensions&&r.extensions[this.name]||{}).light;return a===void 0?null:this._loadLight(a).then(function(c){return n._getNodeRef(t.cache,a,c)})}},ep=class{constructor(){this.name=xt.KHR_MATERIALS_UNLIT}getMaterialType(){return ui}extendParams(e,t,n){let s=[];e.color=new Ke(1,1,1),e.opacity=1;let r=t.pbrMetallicRoughness;if(r){if(Array.isArray(r.baseColorFactor)){let o=r.baseColorFactor;e.color.setRGB(o[0],o[1],o[2],ii),e.opacity=o[3]}r.baseColorTexture!==void 0&&s.push(n.assignTexture(e,"map",r.baseColorTexture,yn))}return Promise.all(s)}},tp=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_EMISSIVE_STRENGTH}extendMaterialParams(e,t){let n=Qt(this.parser,e,this.name);return n===null||n.emissiveStrength!==void 0&&(t.emissiveIntensity=n.emissiveStrength),Promise.resolve()}},np=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_CLEARCOAT}getMaterialType(e){return Qt(this.parser,e,this.name)!==null?si:null}extendMaterialParams(e,t){let n=Qt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];if(n.clearcoatFactor!==void 0&&(t.clearcoat=n.clearcoatFactor),n.clearcoatTexture!==void 0&&s.push(this.parser.assignTexture(t,"clearcoatMap",n.clearcoatTexture)),n.clearcoatRoughnessFactor!==void 0&&(t.clearcoatRoughness=n.clearcoatRoughnessFactor),n.clearcoatRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"clearcoatRoughnessMap",n.clearcoatRoughnessTexture)),n.clearcoatNormalTexture!==void 0&&(s.push(this.parser.assignTexture(t,"clearcoatNormalMap",n.clearcoatNormalTexture)),n.clearcoatNormalTexture.scale!==void 0)){let r=n.clearcoatNormalTexture.scale;t.clearcoatNormalScale=new je(r,r)}return Promise.all(s)}},ip=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_DIFFUSE_ROUGHNESS}getMaterialType(e){return Qt(this.parser,e,this.name)!==null?si:null}extendMaterialParams(e,t){let n=Qt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return t.diffuseRoughness=n.diffuseRoughnessFactor!==void 0?n.diffuseRoughnessFactor:0,n.diffuseRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"diffuseRoughnessMap",n.diffuseRoughnessTexture)),Promise.all(s)}},sp=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_DISPERSION}getMaterialType(e){return Qt(this.parser,e,this.name)!==null?si:null}extendMaterialParams(e,t){let n=Qt(this.parser,e,this.name);return n===null||(t.dispersion=n.dispersion!==void 0?n.dispersion:0),Promise.resolve()}},rp=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_IRIDESCENCE}getMaterialType(e){return Qt(this.parser,e,this.name)!==null?si:null}extendMaterialParams(e,t){let n=Qt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.iridescenceFactor!==void 0&&(t.iridescence=n.iridescenceFactor),n.iridescenceTexture!==void 0&&s.push(this.parser.assignTexture(t,"iridescenceMap",n.iridescenceTexture)),n.iridescenceIor!==void 0&&(t.iridescenceIOR=n.iridescenceIor),n.iridescenceThicknessMinimum!==void 0&&(t.iridescenceThicknessMinimum=n.iridescenceThicknessMinimum),n.iridescenceThicknessMaximum!==void 0&&(t.iridescenceThicknessMaximum=n.iridescenceThicknessMaximum),n.iridescenceThicknessTexture!==void 0&&s.push(this.parser.assignTexture(t,"iridescenceThicknessMap",n.iridescenceThicknessTexture)),Promise.all(s)}},op=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_SHEEN}getMaterialType(e){return Qt(this.parser,e,this.name)!==null?si:null}extendMaterialParams(e,t){let n=Qt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];if(t.sheenColor=new Ke(0,0,0),t.sheenRoughness=0,t.sheen=1,n.sheenColorFactor!==void 0){let r=n.sheenColorFactor;t.sheenColor.setRGB(r[0],r[1],r[2],ii)}return n.sheenRoughnessFactor!==void 0&&(t.sheenRoughness=n.sheenRoughnessFactor),n.sheenColorTexture!==void 0&&s.push(this.parser.assignTexture(t,"sheenColorMap",n.sheenColorTexture,yn)),n.sheenRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"sheenRoughnessMap",n.sheenRoughnessTexture)),Promise.all(s)}},ap=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_TRANSMISSION}getMaterialType(e){return Qt(this.parser,e,this.name)!==null?si:null}extendMaterialParams(e,t){let n=Qt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.transmissionFactor!==void 0&&(t.transmission=n.transmissionFactor),n.transmissionTexture!==void 0&&s.push(this.parser.assignTexture(t,"transmissionMap",n.transmissionTexture)),Promise.all(s)}},lp=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_VOLUME}getMaterialType(e){return Qt(this.parser,e,this.name)!==null?si:null}extendMaterialParams(e,t){let n=Qt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];t.thickness=n.thicknessFactor!==void 0?n.thicknessFactor:0,n.thicknessTexture!==void 0&&s.push(this.parser.assignTexture(t,"thicknessMap",n.thicknessTexture)),t.attenuationDistance=n.attenuationDistance||1/0;let r=n.attenuationColor||[1,1,1];return t.attenuationColor=new Ke().setRGB(r[0],r[1],r[2],ii),Promise.all(s)}},cp=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_IOR}getMaterialType(e){return Qt(this.parser,e,this.name)!==null?si:null}extendMaterialParams(e,t){let n=Qt(this.parser,e,this.name);return n===null||(t.ior=n.ior!==void 0?n.ior:1.5,t.ior===0&&(t.ior=1e3)),Promise.resolve()}},hp=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_SPECULAR}getMaterialType(e){return Qt(this.parser,e,this.name)!==null?si:null}extendMaterialParams(e,t){let n=Qt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];t.specularIntensity=n.specularFactor!==void 0?n.specularFactor:1,n.specularTexture!==void 0&&s.push(this.parser.assignTexture(t,"specularIntensityMap",n.specularTexture));let r=n.specularColorFactor||[1,1,1];return t.specularColor=new Ke().setRGB(r[0],r[1],r[2],ii),n.specularColorTexture!==void 0&&s.push(this.parser.assignTexture(t,"specularColorMap",n.specularColorTexture,yn)),Promise.all(s)}},up=class{constructor(e){this.parser=e,this.name=xt.EXT_MATERIALS_BUMP}getMaterialType(e){return Qt(this.parser,e,this.name)!==null?si:null}extendMaterialParams(e,t){let n=Qt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return t.bumpScale=n.bumpFactor!==void 0?n.bumpFactor:1,n.bumpTexture!==void 0&&s.push(this.parser.assignTexture(t,"bumpMap",n.bumpTexture)),Promise.all(s)}},dp=class{constructor(e){this.parser=e,this.name=xt.KHR_MATERIALS_ANISOTROPY}getMaterialType(e){return Qt(this.parser,e,this.name)!==null?si:null}extendMaterialParams(e,t){let n=Qt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.anisotropyStrength!==void 0&&(t.anisotropy=n.anisotropyStrength),n.anisotropyRotation!==void 0&&(t.anisotropyRotation=n.anisotropyRotation),n.anisotropyTexture!==void 0&&s.push(this.parser.assignTexture(t,"anisotropyMap",n.anisotropyTexture)),Promise.all(s)}},fp=class{constructor(e){this.parser=e,this.name=xt.KHR_TEXTURE_BASISU}loadTexture(e){let t=this.parser,n=t.json,s=n.textures[e];if(!s.extensions||!s.extensions[this.name])return null;let r=s.extensions[this.name],o=t.options.ktx2Loader;if(!o){if(n.extensionsRequired&&n.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setKTX2Loader must be called before loading KTX2 textures");return null}return t.loadTextureImage(e,r.source,o)}},pp=class{constructor(e){this.parser=e,this.name=xt.EXT_TEXTURE_WEBP}loadTexture(e){let t=this.name,n=this.parser,s=n.json,r=s.textures[e];if(!r.extensions||!r.extensions[t])return null;let o=r.extensions[t],a=s.images[o.source],c=n.textureLoader;if(a.uri){let l=n.options.manager.getHandler(a.uri);l!==null&&(c=l)}return n.loadTextureImage(e,o.source,c)}},mp=class{constructor(e){this.parser=e,this.name=xt.EXT_TEXTURE_AVIF}loadTexture(e){let t=this.name,n=this.parser,s=n.json,r=s.textures[e];if(!r.extensions||!r.extensions[t])return null;let o=r.extensions[t],a=s.images[o.source],c=n.textureLoader;if(a.uri){let l=n.options.manager.getHandler(a.uri);l!==null&&(c=l)}return n.loadTextureImage(e,o.source,c)}},Qh=class{constructor(e,t){this.name=t,this.parser=e}loadBufferView(e){let t=this.parser.json,n=t.bufferViews[e];if(n.extensions&&n.extensions[this.name]){let s=n.extensions[this.name],r=this.parser.getDependency("buffer",s.buffer),o=this.parser.options.meshoptDecoder;if(!o||!o.supported){if(t.extensionsRequired&&t.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setMeshoptDecoder must be called before loading compressed files");return null}return r.then(function(a){let c=s.byteOffset||0,l=s.byteLength||0,h=s.count,u=s.byteStride,d=new Uint8Array(a,c,l);return o.decodeGltfBufferAsync?o.decodeGltfBufferAsync(h,u,d,s.mode,s.filter).then(function(f){return f.buffer}):o.ready.then(function(){let f=new ArrayBuffer(h*u);return o.decodeGltfBuffer(new Uint8Array(f),h,u,d,s.mode,s.filter),f})})}else return null}},gp=class{constructor(e){this.name=xt.EXT_MESH_GPU_INSTANCING,this.parser=e}createNodeMesh(e){let t=this.parser.json,n=t.nodes[e];if(!n.extensions||!n.extensions[this.name]||n.mesh===void 0)return null;let s=t.meshes[n.mesh];for(let l of s.primitives)if(l.mode!==Bi.TRIANGLES&&l.mode!==Bi.TRIANGLE_STRIP&&l.mode!==Bi.TRIANGLE_FAN&&l.mode!==void 0)return null;let o=n.extensions[this.name].attributes,a=[],c={};for(let l in o)a.push(this.parser.getDependency("accessor",o[l]).then(h=>(c[l]=h,c[l])));return a.length<1?null:(a.push(this.parser.createNodeMesh(e)),Promise.all(a).then(l=>{let h=l.pop(),u=h.isGroup?h.children:[h],d=l[0].count,f=[];for(let p of u){let v=new ct,g=new V,m=new Fn,y=new V(1,1,1),M=new Qa(p.geometry,p.material,d);for(let C=0;C<d;C++)c.TRANSLATION&&g.fromBufferAttribute(c.TRANSLATION,C),c.ROTATION&&m.fromBufferAttribute(c.ROTATION,C),c.SCALE&&y.fromBufferAttribute(c.SCALE,C),M.setMatrixAt(C,v.compose(g,m,y));let b=null;for(let C in c)if(C==="_COLOR_0"){let A=c[C];M.instanceColor=new Bs(A.array,A.itemSize,A.normalized)}else if(C!=="TRANSLATION"&&C!=="ROTATION"&&C!=="SCALE"){if(b===null){let x=M.geometry;b=new Vn,b.name=x.name;for(let E in x.attributes)b.setAttribute(E,x.attributes[E]);for(let E in x.morphAttributes)b.morphAttributes[E]=x.morphAttributes[E];x.index!==null&&b.setIndex(x.index),b.morphTargetsRelative=x.morphTargetsRelative;for(let E of x.groups)b.addGroup(E.start,E.count,E.materialIndex);x.boundingBox!==null&&(b.boundingBox=x.boundingBox.clone()),x.boundingSphere!==null&&(b.boundingSphere=x.boundingSphere.clone()),b.drawRange.start=x.drawRange.start,b.drawRange.count=x.drawRange.count,b.userData=Object.assign({},x.userData),M.geometry=b}let A=c[C];b.setAttribute(C,new Bs(A.array,A.itemSize,A.normalized))}jt.prototype.copy.call(M,p),this.parser.assignFinalMaterial(M),f.push(M)}return h.isGroup?(h.clear(),h.add(...f),h):f[0]}))}},yx="glTF",Cl=12,gx={JSON:1313821514,BIN:5130562},xp=class{constructor(e){this.name=xt.KHR_BINARY_GLTF,this.content=null,this.body=null;let t=new DataView(e,0,Cl),n=new TextDecoder;if(this.header={magic:n.decode(new Uint8Array(e.slice(0,4))),version:t.getUint32(4,!0),length:t.getUint32(8,!0)},this.header.magic!==yx)throw new Error("THREE.GLTFLoader: Unsupported glTF-Binary header.");if(this.header.version<2)throw new Error("THREE.GLTFLoader: Legacy binary file detected.");let s=this.header.length-Cl,r=new DataView(e,Cl),o=0;for(;o<s;){let a=r.getUint32(o,!0);o+=4;let c=r.getUint32(o,!0);if(o+=4,c===gx.JSON){let l=new Uint8Array(e,Cl+o,a);this.content=n.decode(l)}else if(c===gx.BIN){let l=Cl+o;this.body=e.slice(l,l+a)}o+=a}if(this.content===null)throw new Error("THREE.GLTFLoader: JSON content not found.")}},_p=class{constructor(e,t){if(!t)throw new Error("THREE.GLTFLoader: No DRACOLoader instance provided.");this.name=xt.KHR_DRACO_MESH_COMPRESSION,this.json=e,this.dracoLoader=t,this.dracoLoader.preload()}decodePrimitive(e,t){let n=this.json,s=this.dracoLoader,r=e.extensions[this.name].bufferView,o=e.extensions[this.name].attributes,a={},c={},l={};for(let h in o){let u=Sp[h]||h.toLowerCase();a[u]=o[h]}for(let h in e.attributes){let u=Sp[h]||h.toLowerCase();if(o[h]!==void 0){let d=n.accessors[e.attributes[h]],f=ha[d.componentType];l[u]=f.name,c[u]=d.normalized===!0}}return t.getDependency("bufferView",r).then(function(h){return new Promise(function(u,d){s.decodeDracoFile(h,function(f){for(let p in f.attributes){let v=f.attributes[p],g=c[p];g!==void 0&&(v.normalized=g)}u(f)},a,l,ii,d)})})}},vp=class{constructor(){this.name=xt.KHR_TEXTURE_TRANSFORM}extendTexture(e,t){if((t.texCoord===void 0||t.texCoord===e.channel)&&t.offset===void 0&&t.rotation===void 0&&t.scale===void 0)return e;if(e=e.clone(),t.texCoord!==void 0&&(e.channel=t.texCoord),t.offset!==void 0&&e.offset.fromArray(t.offset),t.rotation!==void 0&&(e.rotation=t.rotation),t.scale!==void 0&&e.repeat.fromArray(t.scale),t.rotation!==void 0){let n=Math.cos(e.rotation),s=Math.sin(e.rotation);e.matrix.set(e.repeat.x*n,e.repeat.y*s,e.offset.x,-e.repeat.x*s,e.repeat.y*n,e.offset.y,0,0,1),e.matrixAutoUpdate=!1}return e.needsUpdate=!0,e}},yp=class{constructor(){this.name=xt.KHR_MESH_QUANTIZATION}},eu=class extends ms{constructor(e,t,n,s){super(e,t,n,s)}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s*3+s;for(let o=0;o!==s;o++)t[o]=n[r+o];return t}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=a*2,l=a*3,h=s-t,u=(n-t)/h,d=u*u,f=d*u,p=e*l,v=p-l,g=-2*f+3*d,m=f-d,y=1-g,M=m-d+u;for(let b=0;b!==a;b++){let C=o[v+b+a],A=o[v+b+c]*h,x=o[p+b+a],E=o[p+b]*h;r[b]=y*C+M*A+g*x+m*E}return r}},pE=new Fn,bp=class extends eu{interpolate_(e,t,n,s){let r=super.interpolate_(e,t,n,s);return pE.fromArray(r).normalize().toArray(r),r}},Bi={FLOAT:5126,FLOAT_MAT3:35675,FLOAT_MAT4:35676,FLOAT_VEC2:35664,FLOAT_VEC3:35665,FLOAT_VEC4:35666,LINEAR:9729,REPEAT:10497,SAMPLER_2D:35678,POINTS:0,LINES:1,LINE_LOOP:2,LINE_STRIP:3,TRIANGLES:4,TRIANGLE_STRIP:5,TRIANGLE_FAN:6,UNSIGNED_BYTE:5121,UNSIGNED_SHORT:5123},ha={5120:Int8Array,5121:Uint8Array,5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},xx={9728:cn,9729:Sn,9984:sh,9985:sa,9986:Zr,9987:Fi},_x={33071:Oi,33648:Fo,10497:fr},jf={SCALAR:1,VEC2:2,VEC3:3,VEC4:4,MAT2:4,MAT3:9,MAT4:16},Sp={POSITION:"position",NORMAL:"normal",TANGENT:"tangent",TEXCOORD_0:"uv",TEXCOORD_1:"uv1",TEXCOORD_2:"uv2",TEXCOORD_3:"uv3",COLOR_0:"color",WEIGHTS_0:"skinWeight",JOINTS_0:"skinIndex"},yr={scale:"scale",translation:"position",rotation:"quaternion",weights:"morphTargetInfluences"},mE={CUBICSPLINE:void 0,LINEAR:Hr,STEP:zr},Zf={OPAQUE:"OPAQUE",MASK:"MASK",BLEND:"BLEND"};function gE(i){return i.DefaultMaterial===void 0&&(i.DefaultMaterial=new Hs({color:16777215,emissive:0,metalness:1,roughness:1,transparent:!1,depthTest:!0,side:xs})),i.DefaultMaterial}function eo(i,e,t){for(let n in t.extensions)i[n]===void 0&&(e.userData.gltfExtensions=e.userData.gltfExtensions||{},e.userData.gltfExtensions[n]=t.extensions[n])}function Ss(i,e){e.extras!==void 0&&(typeof e.extras=="object"?Object.assign(i.userData,e.extras):console.warn("THREE.GLTFLoader: Ignoring primitive type .extras, "+e.extras))}function xE(i,e,t){let n=!1,s=!1,r=!1;for(let l=0,h=e.length;l<h;l++){let u=e[l];if(u.POSITION!==void 0&&(n=!0),u.NORMAL!==void 0&&(s=!0),u.COLOR_0!==void 0&&(r=!0),n&&s&&r)break}if(!n&&!s&&!r)return Promise.resolve(i);let o=[],a=[],c=[];for(let l=0,h=e.length;l<h;l++){let u=e[l];if(n){let d=u.POSITION!==void 0?t.getDependency("accessor",u.POSITION):i.attributes.position;o.push(d)}if(s){let d=u.NORMAL!==void 0?t.getDependency("accessor",u.NORMAL):i.attributes.normal;a.push(d)}if(r){let d=u.COLOR_0!==void 0?t.getDependency("accessor",u.COLOR_0):i.attributes.color;c.push(d)}}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(c)]).then(function(l){let h=l[0],u=l[1],d=l[2];return n&&(i.morphAttributes.position=h),s&&(i.morphAttributes.normal=u),r&&(i.morphAttributes.color=d),i.morphTargetsRelative=!0,i})}function _E(i,e){if(i.updateMorphTargets(),e.weights!==void 0)for(let t=0,n=e.weights.length;t<n;t++)i.morphTargetInfluences[t]=e.weights[t];if(e.extras&&Array.isArray(e.extras.targetNames)){let t=e.extras.targetNames;if(i.morphTargetInfluences.length===t.length){i.morphTargetDictionary={};for(let n=0,s=t.length;n<s;n++)i.morphTargetDictionary[t[n]]=n}else console.warn("THREE.GLTFLoader: Invalid extras.targetNames length. Ignoring names.")}}function vE(i){let e,t=i.extensions&&i.extensions[xt.KHR_DRACO_MESH_COMPRESSION];if(t?e="draco:"+t.bufferView+":"+t.indices+":"+Jf(t.attributes):e=i.indices+":"+Jf(i.attributes)+":"+i.mode,i.targets!==void 0)for(let n=0,s=i.targets.length;n<s;n++)e+=":"+Jf(i.targets[n]);return e}function Jf(i){let e="",t=Object.keys(i).sort();for(let n=0,s=t.length;n<s;n++)e+=t[n]+":"+i[t[n]]+";";return e}function Mp(i){switch(i){case Int8Array:return 1/127;case Uint8Array:return 1/255;case Int16Array:return 1/32767;case Uint16Array:return 1/65535;default:throw new Error("THREE.GLTFLoader: Unsupported normalized accessor component type.")}}function yE(i){return i.search(/\.jpe?g($|\?)/i)>0||i.search(/^data\:image\/jpeg/)===0?"image/jpeg":i.search(/\.webp($|\?)/i)>0||i.search(/^data\:image\/webp/)===0?"image/webp":i.search(/\.ktx2($|\?)/i)>0||i.search(/^data\:image\/ktx2/)===0?"image/ktx2":"image/png"}var bE=new ct,wp=class{constructor(e={},t={}){this.json=e,this.extensions={},this.plugins={},this.options=t,this.cache=new fE,this.associations=new Map,this.primitiveCache={},this.nodeCache={},this.meshCache={refs:{},uses:{}},this.cameraCache={refs:{},uses:{}},this.lightCache={refs:{},uses:{}},this.sourceCache={},this.textureCache={},this.nodeNamesUsed={};let n=!1,s=-1,r=!1,o=-1;if(typeof navigator<"u"&&typeof navigator.userAgent<"u"){let a=navigator.userAgent;n=/^((?!chrome|android).)*safari/i.test(a)===!0;let c=a.match(/Version\/(\d+)/);s=n&&c?parseInt(c[1],10):-1,r=a.indexOf("Firefox")>-1,o=r?a.match(/Firefox\/([0-9]+)\./)[1]:-1}typeof createImageBitmap>"u"||n&&s<17||r&&o<98?(this.textureLoader=new cl(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)):(this.textureLoader=new ml(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)),this.textureLoader.setCrossOrigin(this.options.crossOrigin),this.textureLoader.setWithCredentials(this.options.withCredentials),this.textureLoader.setRequestHeader(this.options.requestHeader),this.fileLoader=new Zo(this.options.manager),this.fileLoader.setPriority(this.options.priority),this.fileLoader.setCache(this.options.cache),this.fileLoader.setResponseType("arraybuffer"),(this.options.withCredentials||this.options.crossOrigin==="use-credentials")&&this.fileLoader.setWithCredentials(!0)}setExtensions(e){this.extensions=e}setPlugins(e){this.plugins=e}parse(e,t){let n=this,s=this.json,r=this.extensions;this.cache.removeAll(),this.nodeCache={},this._invokeAll(function(o){return o._markDefs&&o._markDefs()}),Promise.all(this._invokeAll(function(o){return o.beforeRoot&&o.beforeRoot()})).then(function(){return Promise.all([n.getDependencies("scene"),n.getDependencies("animation"),n.getDependencies("camera")])}).then(function(o){let a={scene:o[0][s.scene||0],scenes:o[0],animations:o[1],cameras:o[2],asset:s.asset,parser:n,userData:{}};return eo(r,a,s),Ss(a,s),Promise.all(n._invokeAll(function(c){return c.afterRoot&&c.afterRoot(a)})).then(function(){for(let c of a.scenes)c.updateMatrixWorld();e(a)})}).catch(t)}_markDefs(){let e=this.json.nodes||[],t=this.json.skins||[],n=this.json.meshes||[];for(let s=0,r=t.length;s<r;s++){let o=t[s].joints;for(let a=0,c=o.length;a<c;a++)e[o[a]].isBone=!0}for(let s=0,r=e.length;s<r;s++){let o=e[s];o.mesh!==void 0&&(this._addNodeRef(this.meshCache,o.mesh),o.skin!==void 0&&(n[o.mesh].isSkinnedMesh=!0)),o.camera!==void 0&&this._addNodeRef(this.cameraCache,o.camera)}}_addNodeRef(e,t){t!==void 0&&(e.refs[t]===void 0&&(e.refs[t]=e.uses[t]=0),e.refs[t]++)}_getNodeRef(e,t,n){if(e.refs[t]<=1)return n;let s=n.clone(),r=(o,a)=>{let c=this.associations.get(o);c!=null&&this.associations.set(a,c);for(let[l,h]of o.children.entries())r(h,a.children[l])};return r(n,s),s.name+="_instance_"+e.uses[t]++,s}_invokeOne(e){let t=Object.values(this.plugins);t.push(this);for(let n=0;n<t.length;n++){let s=e(t[n]);if(s)return s}return null}_invokeAll(e){let t=Object.values(this.plugins);t.unshift(this);let n=[];for(let s=0;s<t.length;s++){let r=e(t[s]);r&&n.push(r)}return n}getDependency(e,t){let n=e+":"+t,s=this.cache.get(n);if(!s){switch(e){case"scene":s=this.loadScene(t);break;case"node":s=this._invokeOne(function(r){return r.loadNode&&r.loadNode(t)});break;case"mesh":s=this._invokeOne(function(r){return r.loadMesh&&r.loadMesh(t)});break;case"accessor":s=this.loadAccessor(t);break;case"bufferView":s=this._invokeOne(function(r){return r.loadBufferView&&r.loadBufferView(t)});break;case"buffer":s=this.loadBuffer(t);break;case"material":s=this._invokeOne(function(r){return r.loadMaterial&&r.loadMaterial(t)});break;case"texture":s=this._invokeOne(function(r){return r.loadTexture&&r.loadTexture(t)});break;case"skin":s=this.loadSkin(t);break;case"animation":s=this._invokeOne(function(r){return r.loadAnimation&&r.loadAnimation(t)});break;case"camera":s=this.loadCamera(t);break;default:if(s=this._invokeOne(function(r){return r!=this&&r.getDependency&&r.getDependency(e,t)}),!s)throw new Error("Unknown type: "+e);break}this.cache.add(n,s)}return s}getDependencies(e){let t=this.cache.get(e);if(!t){let n=this,s=this.json[e+(e==="mesh"?"es":"s")]||[];t=Promise.all(s.map(function(r,o){return n.getDependency(e,o)})),this.cache.add(e,t)}return t}loadBuffer(e){let t=this.json.buffers[e],n=this.fileLoader;if(t.type&&t.type!=="arraybuffer")throw new Error("THREE.GLTFLoader: "+t.type+" buffer type is not supported.");if(t.uri===void 0&&e===0)return Promise.resolve(this.extensions[xt.KHR_BINARY_GLTF].body);let s=this.options;return new Promise(function(r,o){n.load(qs.resolveURL(t.uri,s.path),r,void 0,function(){o(new Error('THREE.GLTFLoader: Failed to load buffer "'+t.uri+'".'))})})}loadBufferView(e){let t=this.json.bufferViews[e];return this.getDependency("buffer",t.buffer).then(function(n){let s=t.byteLength||0,r=t.byteOffset||0;return n.slice(r,r+s)})}loadAccessor(e){let t=this,n=this.json,s=this.json.accessors[e];if(s.bufferView===void 0&&s.sparse===void 0){let o=jf[s.type],a=ha[s.componentType],c=s.normalized===!0,l=new a(s.count*o);return Promise.resolve(new ln(l,o,c))}let r=[];return s.bufferView!==void 0?r.push(this.getDependency("bufferView",s.bufferView)):r.push(null),s.sparse!==void 0&&(r.push(this.getDependency("bufferView",s.sparse.indices.bufferView)),r.push(this.getDependency("bufferView",s.sparse.values.bufferView))),Promise.all(r).then(function(o){let a=o[0],c=jf[s.type],l=ha[s.componentType],h=l.BYTES_PER_ELEMENT,u=h*c,d=s.byteOffset||0,f=s.bufferView!==void 0?n.bufferViews[s.bufferView].byteStride:void 0,p=s.normalized===!0,v,g;if(f&&f!==u){let m=Math.floor(d/f),y="InterleavedBuffer:"+s.bufferView+":"+s.componentType+":"+m+":"+s.count,M=t.cache.get(y);M||(v=new l(a,m*f,s.count*f/h),M=new Wo(v,f/h),t.cache.add(y,M)),g=new Xo(M,c,d%f/h,p)}else a===null?v=new l(s.count*c):v=new l(a,d,s.count*c),g=new ln(v,c,p);if(s.sparse!==void 0){let m=jf.SCALAR,y=ha[s.sparse.indices.componentType],M=s.sparse.indices.byteOffset||0,b=s.sparse.values.byteOffset||0,C=new y(o[1],M,s.sparse.count*m),A=new l(o[2],b,s.sparse.count*c);a!==null&&(g=new ln(g.array.slice(),g.itemSize,g.normalized)),g.normalized=!1;for(let x=0,E=C.length;x<E;x++){let k=C[x];if(g.setX(k,A[x*c]),c>=2&&g.setY(k,A[x*c+1]),c>=3&&g.setZ(k,A[x*c+2]),c>=4&&g.setW(k,A[x*c+3]),c>=5)throw new Error("THREE.GLTFLoader: Unsupported itemSize in sparse BufferAttribute.")}g.normalized=p}return g})}loadTexture(e){let t=this.json,n=this.options,r=t.textures[e].source,o=t.images[r],a=this.textureLoader;if(o.uri){let c=n.manager.getHandler(o.uri);c!==null&&(a=c)}return this.loadTextureImage(e,r,a)}loadTextureImage(e,t,n){let s=this,r=this.json,o=r.textures[e],a=r.images[t],c=(a.uri||a.bufferView)+":"+o.sampler;if(this.textureCache[c])return this.textureCache[c];let l=this.loadImageSource(t,n).then(function(h){h.flipY=!1,h.name=o.name||a.name||"",h.name===""&&typeof a.uri=="string"&&a.uri.startsWith("data:image/")===!1&&(h.name=a.uri);let d=(r.samplers||{})[o.sampler]||{};return h.magFilter=xx[d.magFilter]||Sn,h.minFilter=xx[d.minFilter]||Fi,h.wrapS=_x[d.wrapS]||fr,h.wrapT=_x[d.wrapT]||fr,h.generateMipmaps=!h.isCompressedTexture&&h.minFilter!==cn&&h.minFilter!==Sn,s.associations.set(h,{textures:e}),h}).catch(function(){return null});return this.textureCache[c]=l,l}loadImageSource(e,t){let n=this,s=this.json,r=this.options;if(this.sourceCache[e]!==void 0)return this.sourceCache[e].then(d=>d.clone());let o=s.images[e],a=self.URL||self.webkitURL,c=o.uri||"",l=!1,h;if(t.isKTX2Loader===!0&&o.bufferView!==void 0)h=n.getDependency("bufferView",o.bufferView).then(function(d){return new Promise(function(f,p){t.parse(d,f,p)})});else{if(o.bufferView!==void 0)c=n.getDependency("bufferView",o.bufferView).then(function(d){l=!0;let f=new Blob([d],{type:o.mimeType});return c=a.createObjectURL(f),c});else if(o.uri===void 0)throw new Error("THREE.GLTFLoader: Image "+e+" is missing URI and bufferView");h=Promise.resolve(c).then(function(d){return new Promise(function(f,p){let v=f;t.isImageBitmapLoader===!0&&(v=function(g){let m=new kn(g);m.needsUpdate=!0,f(m)}),t.load(qs.resolveURL(d,r.path),v,void 0,p)})})}let u=h.then(function(d){return l===!0&&a.revokeObjectURL(c),Ss(d,o),d.userData.mimeType=o.mimeType||yE(o.uri),d}).catch(function(d){throw console.error("THREE.GLTFLoader: Couldn't load texture",c),d});return this.sourceCache[e]=u,u}assignTexture(e,t,n,s){let r=this;return this.getDependency("texture",n.index).then(function(o){if(!o)return null;if(n.texCoord!==void 0&&n.texCoord>0&&(o=o.clone(),o.channel=n.texCoord),r.extensions[xt.KHR_TEXTURE_TRANSFORM]){let a=n.extensions!==void 0?n.extensions[xt.KHR_TEXTURE_TRANSFORM]:void 0;if(a){let c=r.associations.get(o);o=r.extensions[xt.KHR_TEXTURE_TRANSFORM].extendTexture(o,a),r.associations.set(o,c)}}return s!==void 0&&(o.colorSpace=s),e[t]=o,o})}assignFinalMaterial(e){let t=e.geometry,n=e.material,s=t.attributes.tangent===void 0,r=t.attributes.color!==void 0,o=t.attributes.normal===void 0;if(e.isPoints){let a="PointsMaterial:"+n.uuid,c=this.cache.get(a);c||(c=new Ko,hi.prototype.copy.call(c,n),c.color.copy(n.color),c.map=n.map,c.sizeAttenuation=!1,this.cache.add(a,c)),n=c}else if(e.isLine){let a="LineBasicMaterial:"+n.uuid,c=this.cache.get(a);c||(c=new Yo,hi.prototype.copy.call(c,n),c.color.copy(n.color),c.map=n.map,this.cache.add(a,c)),n=c}if(s||r||o){let a="ClonedMaterial:"+n.uuid+":";s&&(a+="derivative-tangents:"),r&&(a+="vertex-colors:"),o&&(a+="flat-shading:");let c=this.cache.get(a);c||(c=n.clone(),r&&(c.vertexColors=!0),o&&(c.flatShading=!0),s&&(c.normalScale&&(c.normalScale.y*=-1),c.clearcoatNormalScale&&(c.clearcoatNormalScale.y*=-1)),this.cache.add(a,c),this.associations.set(c,this.associations.get(n))),n=c}e.material=n}getMaterialType(){return Hs}loadMaterial(e){let t=this,n=this.json,s=this.extensions,r=n.materials[e],o,a={},c=r.extensions||{},l=[];if(c[xt.KHR_MATERIALS_UNLIT]){let u=s[xt.KHR_MATERIALS_UNLIT];o=u.getMaterialType(),l.push(u.extendParams(a,r,t))}else{let u=r.pbrMetallicRoughness||{};if(a.color=new Ke(1,1,1),a.opacity=1,Array.isArray(u.baseColorFactor)){let d=u.baseColorFactor;a.color.setRGB(d[0],d[1],d[2],ii),a.opacity=d[3]}u.baseColorTexture!==void 0&&l.push(t.assignTexture(a,"map",u.baseColorTexture,yn)),a.metalness=u.metallicFactor!==void 0?u.metallicFactor:1,a.roughness=u.roughnessFactor!==void 0?u.roughnessFactor:1,u.metallicRoughnessTexture!==void 0&&(l.push(t.assignTexture(a,"metalnessMap",u.metallicRoughnessTexture)),l.push(t.assignTexture(a,"roughnessMap",u.metallicRoughnessTexture))),o=this._invokeOne(function(d){return d.getMaterialType&&d.getMaterialType(e)}),l.push(Promise.all(this._invokeAll(function(d){return d.extendMaterialParams&&d.extendMaterialParams(e,a)})))}r.doubleSided===!0&&(a.side=fi);let h=r.alphaMode||Zf.OPAQUE;if(h===Zf.BLEND?(a.transparent=!0,a.depthWrite=!1):(a.transparent=!1,h===Zf.MASK&&(a.alphaTest=r.alphaCutoff!==void 0?r.alphaCutoff:.5)),r.normalTexture!==void 0&&o!==ui&&(l.push(t.assignTexture(a,"normalMap",r.normalTexture)),a.normalScale=new je(1,1),r.normalTexture.scale!==void 0)){let u=r.normalTexture.scale;a.normalScale.set(u,u)}if(r.occlusionTexture!==void 0&&o!==ui&&(l.push(t.assignTexture(a,"aoMap",r.occlusionTexture)),r.occlusionTexture.strength!==void 0&&(a.aoMapIntensity=r.occlusionTexture.strength)),r.emissiveFactor!==void 0&&o!==ui){let u=r.emissiveFactor;a.emissive=new Ke().setRGB(u[0],u[1],u[2],ii)}return r.emissiveTexture!==void 0&&o!==ui&&l.push(t.assignTexture(a,"emissiveMap",r.emissiveTexture,yn)),Promise.all(l).then(function(){let u=new o(a);return r.name&&(u.name=r.name),Ss(u,r),t.associations.set(u,{materials:e}),r.extensions&&eo(s,u,r),u})}createUniqueName(e){let t=Bt.sanitizeNodeName(e||"");return t in this.nodeNamesUsed?t+"_"+ ++this.nodeNamesUsed[t]:(this.nodeNamesUsed[t]=0,t)}loadGeometries(e){let t=this,n=this.extensions,s=this.primitiveCache;function r(a){return n[xt.KHR_DRACO_MESH_COMPRESSION].decodePrimitive(a,t).then(function(c){return vx(c,a,t)})}let o=[];for(let a=0,c=e.length;a<c;a++){let l=e[a],h=vE(l),u=s[h];if(u)o.push(u.promise);else{let d;l.extensions&&l.extensions[xt.KHR_DRACO_MESH_COMPRESSION]?d=r(l):d=vx(new Vn,l,t),l.mode===Bi.TRIANGLE_STRIP?d=d.then(f=>Kf(f,wl)):l.mode===Bi.TRIANGLE_FAN&&(d=d.then(f=>Kf(f,oa))),s[h]={primitive:l,promise:d},o.push(d)}}return Promise.all(o)}loadMesh(e){let t=this,n=this.json,s=this.extensions,r=n.meshes[e],o=r.primitives,a=[];for(let c=0,l=o.length;c<l;c++){let h=o[c].material===void 0?gE(this.cache):this.getDependency("material",o[c].material);a.push(h)}return a.push(t.loadGeometries(o)),Promise.all(a).then(async function(c){let l=c.slice(0,c.length-1),h=c[c.length-1],u=[];for(let f=0,p=h.length;f<p;f++){let v=h[f],g=o[f],m,y=l[f];if(g.mode===Bi.TRIANGLES||g.mode===Bi.TRIANGLE_STRIP||g.mode===Bi.TRIANGLE_FAN||g.mode===void 0){let M=r.isSkinnedMesh===!0,b=v.hasAttribute("skinIndex")&&v.hasAttribute("skinWeight");M&&b===!1&&console.warn("THREE.GLTFLoader: Missing skinIndex or skinWeight attributes. Skinning disabled."),m=M&&b?new Za(v,y):new Zt(v,y),m.isSkinnedMesh===!0&&m.normalizeSkinWeights()}else if(g.mode===Bi.LINES)m=new el(v,y);else if(g.mode===Bi.LINE_STRIP)m=new Gr(v,y);else if(g.mode===Bi.LINE_LOOP)m=new tl(v,y);else if(g.mode===Bi.POINTS)m=new nl(v,y);else throw new Error("THREE.GLTFLoader: Primitive mode unsupported: "+g.mode);Object.keys(m.geometry.morphAttributes).length>0&&_E(m,r),m.name=t.createUniqueName(r.name||"mesh_"+e),Ss(m,r),g.extensions&&eo(s,m,g),t.assignFinalMaterial(m),u.push(m)}for(let f=0,p=u.length;f<p;f++)t.associations.set(u[f],{meshes:e,primitives:f});if(u.length===1)return r.extensions&&eo(s,u[0],r),u[0];let d=new ni;r.extensions&&eo(s,d,r),t.associations.set(d,{meshes:e});for(let f=0,p=u.length;f<p;f++)d.add(u[f]);return d})}loadCamera(e){let t,n=this.json.cameras[e],s=n[n.type];if(!s){console.warn("THREE.GLTFLoader: Missing camera parameters.");return}return n.type==="perspective"?t=new bn(aa.radToDeg(s.yfov),s.aspectRatio||1,s.znear||1,s.zfar||2e6):n.type==="orthographic"&&(t=new Xr(-s.xmag,s.xmag,s.ymag,-s.ymag,s.znear,s.zfar)),n.name&&(t.name=this.createUniqueName(n.name)),Ss(t,n),Promise.resolve(t)}loadSkin(e){let t=this.json.skins[e],n=[];for(let s=0,r=t.joints.length;s<r;s++)n.push(this._loadNodeShallow(t.joints[s]));return t.inverseBindMatrices!==void 0?n.push(this.getDependency("accessor",t.inverseBindMatrices)):n.push(null),Promise.all(n).then(function(s){let r=s.pop(),o=s,a=[],c=[];for(let l=0,h=o.length;l<h;l++){let u=o[l];if(u){a.push(u);let d=new ct;r!==null&&d.fromArray(r.array,l*16),c.push(d)}else console.warn('THREE.GLTFLoader: Joint "%s" could not be found.',t.joints[l])}return new Ja(a,c)})}loadAnimation(e){let t=this.json,n=this,s=t.animations[e],r=s.name?s.name:"animation_"+e,o=[],a=[],c=[],l=[],h=[];for(let u=0,d=s.channels.length;u<d;u++){let f=s.channels[u],p=s.samplers[f.sampler],v=f.target,g=v.node,m=s.parameters!==void 0?s.parameters[p.input]:p.input,y=s.parameters!==void 0?s.parameters[p.output]:p.output;v.node!==void 0&&(o.push(this.getDependency("node",g)),a.push(this.getDependency("accessor",m)),c.push(this.getDependency("accessor",y)),l.push(p),h.push(v))}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(c),Promise.all(l),Promise.all(h)]).then(function(u){let d=u[0],f=u[1],p=u[2],v=u[3],g=u[4],m=[];for(let M=0,b=d.length;M<b;M++){let C=d[M],A=f[M],x=p[M],E=v[M],k=g[M];if(C===void 0)continue;C.updateMatrix&&C.updateMatrix();let D=n._createAnimationTracks(C,A,x,E,k);if(D)for(let L=0;L<D.length;L++)m.push(D[L])}let y=new ll(r,void 0,m);return Ss(y,s),y})}createNodeMesh(e){let t=this.json,n=this,s=t.nodes[e];return s.mesh===void 0?null:n.getDependency("mesh",s.mesh).then(function(r){let o=n._getNodeRef(n.meshCache,s.mesh,r);return s.weights!==void 0&&o.traverse(function(a){if(a.isMesh)for(let c=0,l=s.weights.length;c<l;c++)a.morphTargetInfluences[c]=s.weights[c]}),o})}loadNode(e){let t=this.json,n=this,s=t.nodes[e],r=n._loadNodeShallow(e),o=[],a=s.children||[];for(let l=0,h=a.length;l<h;l++)o.push(n.getDependency("node",a[l]));let c=s.skin===void 0?Promise.resolve(null):n.getDependency("skin",s.skin);return Promise.all([r,Promise.all(o),c]).then(function(l){let h=l[0],u=l[1],d=l[2];d!==null&&h.traverse(function(f){f.isSkinnedMesh&&f.bind(d,bE)});for(let f=0,p=u.length;f<p;f++)h.add(u[f]);if(h.userData.pivot!==void 0&&u.length>0){let f=h.userData.pivot,p=u[0];h.pivot=new V().fromArray(f),h.position.x-=f[0],h.position.y-=f[1],h.position.z-=f[2],p.position.set(0,0,0),delete h.userData.pivot}return h})}_loadNodeShallow(e){let t=this.json,n=this.extensions,s=this;if(this.nodeCache[e]!==void 0)return this.nodeCache[e];let r=t.nodes[e],o=r.name?s.createUniqueName(r.name):"",a=[],c=s._invokeOne(function(l){return l.createNodeMesh&&l.createNodeMesh(e)});return c&&a.push(c),r.camera!==void 0&&a.push(s.getDependency("camera",r.camera).then(function(l){return s._getNodeRef(s.cameraCache,r.camera,l)})),s._invokeAll(function(l){return l.createNodeAttachment&&l.createNodeAttachment(e)}).forEach(function(l){a.push(l)}),this.nodeCache[e]=Promise.all(a).then(function(l){let h;if(r.isBone===!0?h=new qo:l.length>1?h=new ni:l.length===1?h=l[0]:h=new jt,h!==l[0])for(let u=0,d=l.length;u<d;u++)h.add(l[u]);if(r.name&&(h.userData.name=r.name,h.name=o),Ss(h,r),r.extensions&&eo(n,h,r),r.matrix!==void 0){let u=new ct;u.fromArray(r.matrix),h.applyMatrix4(u)}else r.translation!==void 0&&h.position.fromArray(r.translation),r.rotation!==void 0&&h.quaternion.fromArray(r.rotation),r.scale!==void 0&&h.scale.fromArray(r.scale);if(!s.associations.has(h))s.associations.set(h,{});else if(r.mesh!==void 0&&s.meshCache.refs[r.mesh]>1){let u=s.associations.get(h);s.associations.set(h,{...u})}return s.associations.get(h).nodes=e,h}),this.nodeCache[e]}loadScene(e){let t=this.extensions,n=this.json.scenes[e],s=this,r=new ni;n.name&&(r.name=s.createUniqueName(n.name)),Ss(r,n),n.extensions&&eo(t,r,n);let o=n.nodes||[],a=[];for(let c=0,l=o.length;c<l;c++)a.push(s.getDependency("node",o[c]));return Promise.all(a).then(function(c){for(let h=0,u=c.length;h<u;h++){let d=c[h];d.parent!==null?r.add(px(d)):r.add(d)}let l=h=>{let u=new Map;for(let[d,f]of s.associations)(d instanceof hi||d instanceof kn)&&u.set(d,f);return h.traverse(d=>{let f=s.associations.get(d);f!=null&&u.set(d,f)}),u};return s.associations=l(r),r})}_createAnimationTracks(e,t,n,s,r){let o=[],a=e.name?e.name:e.uuid,c=[];function l(f){f.morphTargetInfluences&&c.push(f.name?f.name:f.uuid)}yr[r.path]===yr.weights?(l(e),e.isGroup&&e.children.forEach(l)):c.push(a);let h;switch(yr[r.path]){case yr.weights:h=Gs;break;case yr.rotation:h=Ws;break;case yr.translation:case yr.scale:h=mr;break;default:n.itemSize===1?h=Gs:h=mr;break}let u=s.interpolation!==void 0?mE[s.interpolation]:Hr,d=this._getArrayFromAccessor(n);for(let f=0,p=c.length;f<p;f++){let v=new h(c[f]+"."+yr[r.path],t.array,d,u);s.interpolation==="CUBICSPLINE"&&this._createCubicSplineTrackInterpolant(v),o.push(v)}return o}_getArrayFromAccessor(e){let t=e.array;if(e.normalized){let n=Mp(t.constructor),s=new Float32Array(t.length);for(let r=0,o=t.length;r<o;r++)s[r]=t[r]*n;t=s}return t}_createCubicSplineTrackInterpolant(e){e.createInterpolant=function(n){let s=this instanceof Ws?bp:eu;return new s(this.times,this.values,this.getValueSize()/3,n)},e.createInterpolant.isInterpolantFactoryMethodGLTFCubicSpline=!0}};function SE(i,e,t){let n=e.attributes,s=new Hn;if(n.POSITION!==void 0){let a=t.json.accessors[n.POSITION],c=a.min,l=a.max;if(c!==void 0&&l!==void 0){if(s.set(new V(c[0],c[1],c[2]),new V(l[0],l[1],l[2])),a.normalized){let h=Mp(ha[a.componentType]);s.min.multiplyScalar(h),s.max.multiplyScalar(h)}}else{console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.");return}}else return;let r=e.targets;if(r!==void 0){let a=new V,c=new V;for(let l=0,h=r.length;l<h;l++){let u=r[l];if(u.POSITION!==void 0){let d=t.json.accessors[u.POSITION],f=d.min,p=d.max;if(f!==void 0&&p!==void 0){if(c.setX(Math.max(Math.abs(f[0]),Math.abs(p[0]))),c.setY(Math.max(Math.abs(f[1]),Math.abs(p[1]))),c.setZ(Math.max(Math.abs(f[2]),Math.abs(p[2]))),d.normalized){let v=Mp(ha[d.componentType]);c.multiplyScalar(v)}a.max(c)}else console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.")}}s.expandByVector(a)}i.boundingBox=s;let o=new ci;s.getCenter(o.center),o.radius=s.min.distanceTo(s.max)/2,i.boundingSphere=o}function vx(i,e,t){let n=e.attributes,s=[];function r(o,a){return t.getDependency("accessor",o).then(function(c){i.setAttribute(a,c)})}for(let o in n){let a=Sp[o]||o.toLowerCase();a in i.attributes||s.push(r(n[o],a))}if(e.indices!==void 0&&!i.index){let o=t.getDependency("accessor",e.indices).then(function(a){i.setIndex(a)});s.push(o)}return mt.workingColorSpace!==ii&&"COLOR_0"in n&&console.warn(`THREE.GLTFLoader: Converting vertex colors from "srgb-linear" to "${mt.workingColorSpace}" not supported.`),Ss(i,e),SE(i,e,t),Promise.all(s).then(function(){return e.targets!==void 0?xE(i,e.targets,t):i})}function q(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))n.setAttribute(s,r);return n.append(...t),n}function R(i){let e=document.getElementById(i);if(!e)throw new Error(`no element ${i}`);return e}function Ft(i,e,t={}){let n=q("button",{type:"button",...t},i);return n.addEventListener("click",e),n}function Ne(i,e=4){if(!Number.isFinite(i))return"\u2013";let t=Math.abs(i);return t!==0&&(t<.001||t>=1e6)?i.toExponential(e-1).replace("-","\u2212"):String(Number(i.toPrecision(e))).replace("-","\u2212")}function wi(i){return i.replace("um","\xB5m").replace("^2","\xB2").replace("^3","\xB3")}function br(i){return i.replace(/(\d) u(?=[NmVA]\b)/g,"$1 \xB5")}function Ep(i,e=""){let t=q("a",{href:i,download:e,hidden:""});document.body.append(t),t.click(),t.remove()}function Ti(i,e){let t=URL.createObjectURL(i);Ep(t,e),setTimeout(()=>URL.revokeObjectURL(t),6e4)}function Ji(i,e){let t=n=>{if(typeof n=="number")return String(n);let s=/^[=+@\t\r-]/.test(n)?`'${n}`:n;return/[",\n\r]/.test(s)?`"${s.replaceAll('"','""')}"`:s};Ti(new Blob([i.map(n=>n.map(t).join(",")).join(`
`)+`
`],{type:"text/csv"}),e)}var tu=new Map;function Ap(i,e){e&&tu.has(i)||(clearTimeout(tu.get(i)),tu.delete(i),e?tu.set(i,window.setTimeout(()=>i.classList.add("stale"),250)):i.classList.remove("stale"))}var Tp=new Map;function Re(i){let e=Tp.get(i);return e===void 0&&Tp.set(i,e=getComputedStyle(document.documentElement).getPropertyValue(i).trim()),e}function bx(){Tp.clear()}var nu=[[68,1,84],[65,68,135],[42,120,142],[34,168,132],[122,209,81],[253,231,37]];function Pl(i){let t=(document.documentElement.dataset.theme==="dark"?.22+.78*i:.86*i)*(nu.length-1),n=Math.min(Math.floor(t),nu.length-2);return`rgb(${nu[n].map((r,o)=>Math.round(r+(t-n)*(nu[n+1][o]-r))).join(",")})`}var Rp=18,Cp=17,Sx=4,ME=40,Kn=[27,10],Mx=[Rp+Cp+2*Kn[0]-Kn[1],Rp+Cp+Kn[1]],iu=class{constructor(e,t,n){this.place=e;this.set=t;this.redraw=n}place;set;redraw;spans=[];middle=new V;inputs=new Map;measure(e,t){[this.spans,this.middle]=[e,t];for(let[n,s]of this.inputs)s.hidden=!e.some(r=>r.size===n);for(let{size:n,title:s,value:r}of e){let o=this.inputs.get(n)??this.input(n);o.title=this.set?`${s}, mm: type another one`:`${s}, mm`,o.setAttribute("aria-label",`${s}, mm`),o.dataset.shown=Ne(r),document.activeElement!==o&&(o.value=o.dataset.shown)}}refuse(e){this.inputs.get(e)?.setAttribute("aria-invalid","true")}input(e){let t=q("input",{type:"text",class:"dimension",inputmode:"decimal",autocomplete:"off","data-size":e});t.readOnly=!this.set;let n=()=>{t.removeAttribute("aria-invalid"),t.value=t.dataset.shown};return t.addEventListener("change",()=>{let s=t.value.replace("\u2212","-").replace(",",".").trim();t.removeAttribute("aria-invalid"),this.set?.(e,s===""||!Number.isFinite(Number(s))?t.value:Number(s))}),t.addEventListener("keydown",s=>{s.key==="Escape"&&(n(),t.blur())}),t.addEventListener("blur",()=>{n(),this.redraw()}),this.inputs.set(e,t),this.place.append(t),t}draw(e,t,n=!1){let s=this.place.clientWidth,r=this.place.clientHeight,o=[];if(!this.spans.length||!s)return;let a=l=>{let{x:h,y:u,z:d}=l.clone().project(t);return{x:(.5+.5*h)*s,y:(.5-.5*u)*r,behind:d>1}},c=a(this.middle);e.save(),e.setTransform(e.canvas.width/s,0,0,e.canvas.height/r,0,0);for(let l of this.spans){let h=([D,L],[W,X])=>Math.hypot(W.x+X.x-2*c.x,W.y+X.y-2*c.y)-Math.hypot(D.x+L.x-2*c.x,D.y+L.y-2*c.y),[u,d]=l.edges.map(D=>D.map(a)).sort(h)[0],f=this.inputs.get(l.size);if(f.style.visibility=u.behind||d.behind?"hidden":"",u.behind||d.behind)continue;let p=Math.hypot(d.x-u.x,d.y-u.y),v={x:(u.x+d.x)/2-c.x,y:(u.y+d.y)/2-c.y},[g,m]=p>6?[{x:(u.y-d.y)/p,y:(d.x-u.x)/p},1]:[v,Math.hypot(v.x,v.y)||1],y=g.x*v.x+g.y*v.y<0?-1:1,M={x:y*g.x/m,y:y*g.y/m},b=l.size==="pitch"?0:Rp,C=(D,L)=>[D.x+L*M.x,D.y+L*M.y];for(let[D,L]of[["--card",3.5],["--ink-soft",1.2]]){e.strokeStyle=Re(D),e.lineWidth=L,e.beginPath(),e.moveTo(...C(u,b)),e.lineTo(...C(d,b));let W=b&&p>ME?4:b-Sx;for(let X of[u,d])e.moveTo(...C(X,W)),e.lineTo(...C(X,b+Sx));e.stroke()}let[A,x]=C({x:(u.x+d.x)/2,y:(u.y+d.y)/2},b+Cp+Math.abs(M.x)*(Kn[0]-Kn[1])),E=(D,L,W)=>Math.min(Math.max(D,L+2),W-L-2),k={x:E(A,Kn[0],s),y:E(x,Kn[1],r)};for(;o.some(D=>Math.abs(D.x-k.x)<2*Kn[0]&&Math.abs(D.y-k.y)<2*Kn[1])&&k.y>0;)k.y-=Kn[1];o.push(k),Object.assign(f.style,{left:`${k.x-Kn[0]}px`,top:`${k.y-Kn[1]}px`}),n&&(e.font="12px system-ui",[e.textAlign,e.textBaseline,e.fillStyle]=["center","middle",Re("--card")],e.fillRect(k.x-Kn[0],k.y-Kn[1],2*Kn[0],2*Kn[1]),e.fillStyle=Re("--ink"),e.fillText(f.dataset.shown,k.x,k.y))}e.restore()}};var wE=5,Pp=6e3;function Ks([i,e,t]){return new V(i/1e3,t/1e3,-e/1e3)}function wx({x:i,y:e,z:t}){return[1e3*i,-1e3*t,1e3*e]}var su=class{constructor(e,t,n,s,r,o,a,c){this.place=e;this.sheet=t;this.camera=n;this.origin=s;this.take=r;this.turn=o;this.send=a;this.redraw=c;e.append(this.note),e.addEventListener("pointerdown",l=>this.begin(l),{capture:!0}),t.addEventListener("pointermove",l=>this.move(l));for(let l of["pointerup","pointercancel"])t.addEventListener(l,()=>this.end());addEventListener("keydown",l=>{l.key==="Escape"&&this.active&&(this.ask([0,0,0]),this.end())})}place;sheet;camera;origin;take;turn;send;redraw;active=!1;hold=null;plane=new zn;down=[0,0];now=[0,0];held=0;gesture="";refused="";note=q("div",{id:"drag-note",role:"status",hidden:""});leaving=0;begin(e){e.target!==this.sheet||e.button!==0||!R("movable").checked||(this.hold=this.take(e),this.hold&&(this.turn(!1),this.sheet.setPointerCapture(e.pointerId),this.down=this.now=[e.clientX,e.clientY],this.plane.setFromNormalAndCoplanarPoint(this.hold.normal,this.hold.at),this.gesture=`drag-${++this.held}-${Date.now()}`))}move(e){if(!this.hold||!this.active&&Math.hypot(e.clientX-this.down[0],e.clientY-this.down[1])<wE)return;this.active=!0,this.now=[e.clientX,e.clientY];let t=this.sheet.getBoundingClientRect(),n=new $r;n.setFromCamera(new je(2*(e.clientX-t.left)/t.width-1,1-2*(e.clientY-t.top)/t.height),this.camera);let s=n.ray.intersectPlane(this.plane,new V);s&&this.ask(wx(s.sub(this.hold.at)),e.shiftKey),this.redraw()}ask(e,t=!1){let n=wx(this.hold.at.clone().sub(this.origin()));this.send({do:"drag",part:this.hold.group,by:e,at:n,row:t,gesture:this.gesture})}end(){this.hold&&(this.turn(!0),this.hold=null,this.active=!1,clearTimeout(this.leaving),this.leaving=window.setTimeout(()=>{this.note.hidden=!0},this.refused?Pp:Pp/4),this.redraw())}say({words:e,refused:t}){clearTimeout(this.leaving),this.active||(this.leaving=window.setTimeout(()=>{this.note.hidden=!0},Pp)),this.refused=t,this.note.hidden=!1,this.note.classList.toggle("refused",t!==""),this.note.replaceChildren(...e?[q("strong",{},e)]:[],...t?[q("span",{},t)]:[]);let n=this.place.getBoundingClientRect(),[s,r]=[this.now[0]-n.left,this.now[1]-n.top],o=Math.min(Math.max(s+16,4),n.width-this.note.offsetWidth-4),a=r+20+this.note.offsetHeight<n.height;Object.assign(this.note.style,{left:`${o}px`,top:`${a?r+20:Math.max(r-20-this.note.offsetHeight,4)}px`})}draw(e,t){if(!this.active||!this.refused)return;let n=this.sheet.getBoundingClientRect(),s=this.sheet.width/n.width;e.save(),e.strokeStyle=Re("--bad"),e.lineWidth=2*s,e.setLineDash([6*s,4*s]),e.beginPath(),e.arc((this.now[0]-n.left)*s,(this.now[1]-n.top)*s,t,0,7),e.stroke(),e.restore()}};var Tx={shell:"shells",membrane:"membranes",sheath:"tube sheaths",spring:"tube springs",housing:"microphone housings",board:"boards",package:"microphones",base:"base plate",body:"body"},TE={membrane:2.2,shell:0,sheath:-1.2,spring:1.1,housing:0,board:1.6,package:3},Ex={membrane:"drag it to move it",housing:"drag it to another place or side",board:"drag it to another place or side",package:"drag it to another place or side",sheath:"drag its end to change its length",spring:"drag its end to change its length"},ru=class{constructor(e,t,n,s,r){this.place=e;this.colourOf=t;this.choose=n;this.hover=s;this.dimensions=new iu(e,r?.resize??null,()=>this.ask());try{this.renderer=new $h({antialias:!0})}catch{e.append(q("p",{class:"problem"},"This browser draws nothing in three dimensions (WebGL is off)."));return}let o=this.sheet;e.prepend(o),this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.renderer.localClippingEnabled=!0,this.controls=new Zh(this.camera,o),this.controls.addEventListener("change",()=>this.ask()),this.controls.addEventListener("start",()=>{this.turned=!0});let a=new qr(16777215,1.6);if(a.position.set(.4,1,.7),this.scene.add(new hl(16777215,9081500,1.6),new pl(16777215,.35),a,this.model),new ResizeObserver(()=>this.fit()).observe(e),new IntersectionObserver(l=>{this.inSight=l.at(-1).isIntersecting,this.inSight&&this.owed&&this.ask()}).observe(e),r){let l=h=>{this.controls.enabled=h};this.dragging=new su(e,o,this.camera,()=>this.model.position,h=>this.hold(h),l,r.drag,()=>this.copy())}let c=[0,0];o.addEventListener("pointerdown",l=>{c=[l.clientX,l.clientY]}),o.addEventListener("pointermove",l=>{l.buttons||this.name(l)}),o.addEventListener("pointerleave",()=>this.hover(null)),o.addEventListener("click",l=>{if(Math.hypot(l.clientX-c[0],l.clientY-c[1])>=5)return;let h=this.onBody(l);h?this.choosing.click(h):this.choose(this.pointOf(this.under(l)?.part??null),l.shiftKey,u=>this.reached(l,u))}),o.addEventListener("keydown",l=>this.key(l));for(let l of["exploded","section"])R(l).addEventListener("input",()=>this.arrange());R("dimensions").addEventListener("change",()=>{this.arrange(),this.see()}),R("refit").addEventListener("click",()=>this.see())}place;colourOf;choose;hover;renderer=null;scene=new Ya;camera=new bn(35,1,5e-4,20);controls=null;model=new ni;parts=new Map;home=new Map;hidden=new Set;marks=[];dimensions;dragging=null;moved=null;extent=new Hn;fittedTo=0;fittedAt=new V;turned=!1;cut=new zn(new V(0,0,-1),0);lit=()=>!1;choosing=null;sheet=q("canvas",{tabindex:"0",role:"img","aria-label":"the array in three dimensions; arrow keys turn it, plus and minus zoom"});still=q("canvas");touched=null;pointed=null;recoloured=!1;later=0;asked=!1;inSight=!1;owed=!1;size=[0,0,0];get isDragged(){return this.dragging?.active??!1}get isMoved(){return this.moved!==null}async take(e,t){if(R("array-note").textContent=e.notes.join(" "),!this.renderer)return;let n=await fetch(e.file,{headers:yo()});if(!n.ok)throw new Error(`${e.file}: ${n.status}`);let s=await new Jh().parseAsync(await n.arrayBuffer(),"");if(this.moved&&t<this.moved.revision)return;this.moved?.revision===t&&this.model.position.add(Ks(this.moved.shift)),this.choosing&&this.model.position.set(0,0,0),this.moved=null,this.clear(),this.parts=new Map(e.parts.map(a=>[a.label,a])),this.size=e.size,this.model.add(s.scene),this.home.clear(),s.scene.traverse(a=>{if(this.parts.has(a.name)&&this.home.set(a,{position:a.position.clone(),turn:a.quaternion.clone()}),!(a instanceof Zt))return;let c=a.material.clone();c.userData={colour:c.color.clone(),opacity:c.opacity},a.material=c}),this.model.updateMatrixWorld(!0),this.extent.makeEmpty();for(let a of this.home.keys())["board","body"].includes(this.parts.get(a.name).kind)||this.extent.expandByObject(a,!0);this.switches(e.parts);let r=Math.hypot(...e.size),o=1e3*this.extent.getCenter(new V).distanceTo(this.fittedAt);this.arrange(),(Math.abs(Math.log(r/(this.fittedTo||1)))>.08||o>.2*r)&&this.see()}offer(e){if(!e&&!this.choosing)return;let t=this.choosing,n=t?.body!==e?.body||t?.alone!==e?.alone;t?.body.group.removeFromParent(),this.choosing=e,this.renderer&&(e&&this.scene.add(e.body.group),this.arrange(),n&&this.see())}follow(e){this.dragging?.say(e),this.moved=e.words||this.moved?e:null,this.arrange()}light(e,t=[]){this.lit=e;for(let n of this.marks)n.removeFromParent(),n.geometry.dispose();this.marks=[];for(let[n]of this.home)for(let{part:s,place:r}of t){if(!r||this.parts.get(n.name)?.part!==s)continue;let o=new Zt(new Wr(.35,12,8),new ui({color:Re("--bad"),depthTest:!1,transparent:!0}));o.position.set(r[0],r[1],r[2]),o.renderOrder=5,n.add(o),this.marks.push(o)}this.arrange()}touch(e){this.touched=e,this.inSight?!this.asked&&this.renderer&&this.copy():this.owed=!0}point(e){e!==this.pointed&&(this.pointed=e,this.inSight&&!this.asked&&this.renderer&&this.copy())}recolour(){if(this.home.size){if(!this.inSight||this.asked||!this.renderer)return this.arrange();this.recoloured=!0,this.copy(),window.clearTimeout(this.later),this.later=window.setTimeout(()=>this.arrange(),150)}}thumbnail(){if(!this.renderer||!this.fittedTo)return"";let{width:e,height:t}=this.still,n=q("canvas",{width:"300",height:"168"}),s=n.getContext("2d");s.fillStyle=Re("--card"),s.fillRect(0,0,300,168);let r=Math.min(300/e,168/t);return s.drawImage(this.still,(300-r*e)/2,(168-r*t)/2,r*e,r*t),n.toDataURL("image/jpeg",.7)}picture(e){this.draw(),this.copy(!0),this.sheet.toBlob(t=>t&&Ti(t,`${e}-array.png`))}restyle(){this.home.size?this.arrange():this.ask()}switches(e){let t=R("kinds"),n=new Set(e.map(r=>r.kind)),s=[...Object.keys(Tx).filter(r=>n.delete(r)),...n];t.replaceChildren(...s.map(r=>{let o=q("input",{type:"checkbox"});return o.checked=!this.hidden.has(r),o.addEventListener("change",()=>{o.checked?this.hidden.delete(r):this.hidden.add(r),this.arrange()}),q("label",{},o,` ${Tx[r]??r} (${e.filter(a=>a.kind===r).length})`)}))}arrange(){let e=Number(R("exploded").value)/100,t=Math.max(this.size[2],1)/1e3,n=Number(R("section").value)/100,s=this.extent;this.cut.constant=s.isEmpty()?1e3:s.max.z-n*(s.max.z-s.min.z)+(n===0?1:0);let r=new Ke(Re("--accent")),o=this.carried();for(let[h,{position:u,turn:d}]of this.home){let f=this.parts.get(h.name),p=o.get(f.group);h.visible=!this.hidden.has(f.kind)&&!(this.choosing&&(this.choosing.alone||f.kind==="body"))&&!(this.moved&&f.group.startsWith("tube ")),h.position.copy(u),h.quaternion.copy(d),p&&(h.position.sub(p.from).applyQuaternion(p.turn).add(p.to),h.quaternion.premultiply(p.turn)),h.position.y+=e*(TE[f.kind]??0)*t;let v=this.lit(f),g=f.kind==="membrane"?this.pointOf(f):null,m=g===null?null:new Ke(this.colourOf(g));h.traverse(y=>{if(!(y instanceof Zt)||this.marks.includes(y))return;let M=y.material;M.clippingPlanes=n===0?[]:[this.cut],M.color.copy(v?r:m??M.userData.colour),M.emissive.copy(v?r:new Ke(0)),M.emissiveIntensity=v?.5:0,M.opacity=v||m?1:M.userData.opacity})}this.measure();let[a,c,l]=this.size;a&&(R("size").textContent=`${Ne(Math.max(a,c))} \xD7 ${Ne(Math.min(a,c))} \xD7 ${Ne(l)} mm`),this.ask()}carried(){let e=new Map;if(!this.moved)return e;for(let[t,{position:n,turn:s}]of this.home){let{kind:r,group:o}=this.parts.get(t.name),a=this.pointOf(this.parts.get(t.name)),c=r==="shell"&&a?this.moved.points[a-1]:r==="housing"?this.moved.microphones[o.replace("microphone ","")]:void 0;if(!c)continue;let l=new V(0,0,1).applyQuaternion(s),h=Ks(c.slice(3)).normalize();e.set(o,{from:n,to:Ks(c),turn:new Fn().setFromUnitVectors(l,h)})}return e}measure(){let{min:e,max:t}=this.extent,[n,s,r]=this.size;if(!R("dimensions").checked||this.extent.isEmpty()||this.moved||this.choosing?.alone)return this.dimensions.measure([],this.extent.min);this.place.dataset.measured=[t.x-e.x,t.z-e.z,t.y-e.y].map(d=>Ne(1e3*d,3)).join(" ");let o=(d,f,p)=>new V(d,f,p),a=[e,t],c=d=>a.flatMap(f=>a.map(p=>d(f,p))),l=[{size:"x",title:"length along x",edges:c((d,f)=>[o(e.x,d.y,f.z),o(t.x,d.y,f.z)]),value:n},{size:"y",title:"length along y",edges:c((d,f)=>[o(d.x,f.y,e.z),o(d.x,f.y,t.z)]),value:s},{size:"z",title:"height",edges:c((d,f)=>[o(d.x,e.y,f.z),o(d.x,t.y,f.z)]),value:r}],[h,u]=[1,2].map(d=>[...this.home].find(([f])=>{let p=this.parts.get(f.name);return p.kind==="membrane"&&p.group===`point ${d}`}));if(h&&u){let[d,f]=[h,u].map(([,p])=>p.position.clone().add(this.model.position));l.push({size:"pitch",title:"pitch, from point 1 to point 2",edges:[[d,f]],value:1e3*d.distanceTo(f)})}this.dimensions.measure(l,this.extent.getCenter(new V))}refuseSize(e){this.dimensions.refuse(e)}see(){let e=new Hn().setFromObject(this.choosing?.alone?this.choosing.body.group:this.model);if(this.choosing&&e.expandByObject(this.choosing.body.group),e.isEmpty()||!this.controls)return;let t=e.getCenter(new V),n=e.getSize(new V),s=Math.tan(this.camera.fov*Math.PI/360),r=R("dimensions").checked?Mx:[0,0],[o,a]=[this.place.clientWidth,this.place.clientHeight].map((l,h)=>1.12*l/Math.max(l-2*r[h],l/3)),c=Math.max(o*n.x/(2*s*this.camera.aspect),a*(n.z*.75+n.y)/(2*s))+n.z/3;this.camera.position.copy(t).add(new V(0,.78,.62).normalize().multiplyScalar(c)),this.controls.target.copy(t),this.controls.update(),this.fittedTo=Math.hypot(...this.size),this.extent.getCenter(this.fittedAt),this.turned=!1,this.ask()}fit(){let e=this.place.clientWidth,t=this.place.clientHeight;if(!this.renderer||e===0||t===0)return;this.renderer.setSize(e,t,!1);let{width:n,height:s}=this.renderer.domElement;for(let r of[this.sheet,this.still])Object.assign(r,{width:n,height:s});Object.assign(this.sheet.style,{width:`${e}px`,height:`${t}px`}),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.turned||this.moved?this.ask():this.see()}ask(){this.owed=!this.inSight,!(this.asked||this.owed)&&(this.asked=!0,requestAnimationFrame(()=>{this.asked=!1,this.draw()}))}draw(){this.renderer&&(this.renderer.setClearColor(new Ke(Re("--card"))),this.renderer.render(this.scene,this.camera),Ax(this.still).drawImage(this.renderer.domElement,0,0),this.recoloured=!1,this.copy(),document.documentElement.dataset.drawn=String(Number(document.documentElement.dataset.drawn??0)+1))}copy(e=!1){let t=Ax(this.sheet);t.drawImage(this.still,0,0);for(let[n]of this.home){let s=this.parts.get(n.name);s.kind!=="membrane"||!n.visible||(this.recoloured&&this.fill(t,n,this.colourOf(this.pointOf(s))),s.group===`point ${this.touched}`?this.fill(t,n,Re("--accent")):s.group===`point ${this.pointed}`&&this.fill(t,n,Re("--accent"),.6))}document.documentElement.dataset.coloured=String(Number(document.documentElement.dataset.coloured??0)+Number(this.recoloured)),this.moved&&this.trace(t,this.moved),this.dimensions.draw(t,this.camera,e),this.dragging?.draw(t,14*(this.sheet.width/this.place.clientWidth))}trace(e,t){e.save(),e.strokeStyle=Re("--ink-soft"),e.lineWidth=2.5*(this.sheet.width/this.place.clientWidth),e.beginPath();for(let n of t.tubes)n.forEach((s,r)=>{let{x:o,y:a}=Ks(s).add(this.model.position).project(this.camera),c=[(.5+.5*o)*this.sheet.width,(.5-.5*a)*this.sheet.height];r?e.lineTo(...c):e.moveTo(...c)});e.stroke(),e.restore()}fill(e,t,n,s=1){e.beginPath(),t.traverse(r=>{if(!(r instanceof Zt))return;let{index:o,attributes:{position:a}}=r.geometry,c=o?.count??a.count;for(let l=0;l<c;l+=3){let h=[0,1,2].map(y=>new V().fromBufferAttribute(a,o?o.getX(l+y):l+y).applyMatrix4(r.matrixWorld));if(h.some(y=>this.cut.distanceToPoint(y)<0))continue;let u=h.map(y=>y.project(this.camera)).map(({x:y,y:M})=>[(.5+.5*y)*this.sheet.width,(.5-.5*M)*this.sheet.height]),[[d,f],[p,v],[g,m]]=u;(p-d)*(m-f)<(g-d)*(v-f)&&u.reverse(),e.moveTo(u[0][0],u[0][1]),e.lineTo(u[1][0],u[1][1]),e.lineTo(u[2][0],u[2][1])}}),e.fillStyle=n,e.globalAlpha=s,e.fill(),e.globalAlpha=1}ray(e){let t=this.sheet.getBoundingClientRect(),n=new je(2*(e.clientX-t.left)/t.width-1,1-2*(e.clientY-t.top)/t.height),s=new $r;return this.camera.updateMatrixWorld(),this.scene.updateMatrixWorld(),s.setFromCamera(n,this.camera),s}*hits(e){for(let t of this.ray(e).intersectObject(this.model,!0)){let n=t.object;for(;n&&!this.parts.has(n.name);)n=n.parent;let s=n&&this.parts.get(n.name);n?.visible&&s&&(yield{part:s,hit:t})}}under(e){for(let t of this.hits(e))if(t.part.kind!=="body")return t;return null}reached(e,t){let{value:n}=this.hits(e).next(),s=n&&this.pointOf(n.part);if(!n||s)return s??null;let r=([c])=>1e3*(c.getWorldPosition(new V).distanceTo(n.hit.point)-this.radiusOf(c)),a=[...this.home].filter(([c])=>this.parts.get(c.name).kind==="membrane").reduce((c,l)=>r(l)<r(c)?l:c);return r(a)<=t?this.pointOf(this.parts.get(a[0].name)):null}radiusOf(e){let t=new Hn().setFromObject(e,!0).getSize(new V);return Math.max(t.x,t.y,t.z)/2}onBody(e){if(!this.choosing)return null;let[t]=this.ray(e).intersectObject(this.choosing.body.group,!0),n=this.under(e);return t&&!(n&&n.hit.distance<t.distance)?this.choosing.body.hit(t):null}hold(e){let t=this.under(e);if(!t||!Ex[t.part.kind])return null;let n=t.hit.point,s=a=>a.getWorldPosition(new V).distanceTo(n),o=[...this.home.keys()].filter(a=>this.parts.get(a.name).kind==="membrane").reduce((a,c)=>s(c)<s(a)?c:a);return{group:t.part.group,at:n,normal:new V(0,0,1).applyQuaternion(o.quaternion)}}pointOf(e){let t=e?.group.match(/^point (\d+)$/);return t?Number(t[1]):null}name(e){let t=this.onBody(e);if(t)return R("pointed-part").textContent=`\xB7 ${this.choosing.words(t)}`,this.sheet.style.cursor="pointer",this.hover(null);let n=this.under(e)?.part??null,s=n&&this.dragging&&R("movable").checked?Ex[n.kind]:void 0;R("pointed-part").textContent=n?"\xB7 "+n.label.replaceAll("_"," ")+(s?`: ${s}`:""):"\xA0",this.sheet.style.cursor=s?"move":"grab",this.hover(this.pointOf(n))}key(e){let t={ArrowLeft:[-.1,0],ArrowRight:[.1,0],ArrowUp:[0,-.1],ArrowDown:[0,.1]},n=e.key==="+"?.9:e.key==="-"?1.1:1,s=t[e.key]??[0,0];if(n===1&&!s[0]&&!s[1])return;e.preventDefault();let r=this.camera.position.clone().sub(this.controls.target),o=r.length()*n,a=Math.acos(r.y/r.length())+s[1],c=Math.atan2(r.x,r.z)+s[0];this.turned=!0;let l=Math.min(Math.max(a,.02),3.1);this.camera.position.copy(this.controls.target).add(new V(o*Math.sin(l)*Math.sin(c),o*Math.cos(l),o*Math.sin(l)*Math.cos(c))),this.controls.update(),this.ask()}clear(){this.model.traverse(e=>{e instanceof Zt&&(e.geometry.dispose(),e.material.dispose())}),this.model.clear(),this.marks=[]}};function Ax(i){return i.getContext("2d",{willReadFrequently:!0})}var Ip={ok:"\u2713",warn:"!",fail:"\u2717"},ou=class{constructor(e){this.light=e}light;now=null;take(e){this.now=e;let t=e.printing.findings,n=o=>t.filter(a=>a.verdict===o).length;R("print-verdict").textContent=`${e.verdict[0].toUpperCase()}${e.verdict.slice(1)}. ${e.printing.process.title}: ${n("fail")} failed, ${n("warn")} to look at, ${n("ok")} in order.`;let s=[...e.overlaps,...e.misfits,...e.mend?[e.mend]:[]];R("troubles").replaceChildren(...s.map(o=>q("li",{},o)));let r=t.filter(o=>o.verdict!=="ok").sort((o,a)=>+(o.verdict==="warn")-+(a.verdict==="warn"));R("findings").replaceChildren(...r.map(o=>this.row(o))),R("in-order").replaceChildren(...t.filter(o=>o.verdict==="ok").map(o=>this.row(o))),R("validity").replaceChildren(...e.validity.map(o=>q("li",{class:o.holds?"ok":"fail"},q("span",{class:"sign"},o.holds?Ip.ok:Ip.fail),q("span",{},`${o.assumption}: ${Ne(o.value)} ${wi(o.unit)}, ${o.relation} ${Ne(o.limit)} ${wi(o.unit)}; ${o.meaning}`))))}rows(){let e=["part","rule","value","relation","limit","unit","verdict"],t=this.now;return t?[e,...t.printing.findings.map(n=>[n.part,n.rule,n.value,n.relation,n.limit,n.unit,n.verdict]),...t.validity.map(n=>["model",n.assumption,n.value,n.relation,n.limit,n.unit,n.holds?"ok":"fail"])]:[e]}row(e){let t=`${e.part}: ${e.rule} ${Ne(e.value,3)} ${wi(e.unit)}, ${e.relation} ${Ne(e.limit,3)} ${wi(e.unit)}`,n=Ft(t,()=>this.light(e.part,e.place),{class:"finding",title:e.reason});return q("li",{class:e.verdict},q("span",{class:"sign",title:e.verdict},Ip[e.verdict]),n)}};var au=class{constructor(e){this.colouring=e}colouring;shown=null;show(e){this.shown=e;let t=R("point-card");if(t.hidden=e===null,e===null)return;let n=q("span",{class:"swatch"});n.style.background=this.colouring.of(e),t.dataset.point=String(e),t.replaceChildren(q("strong",{},n,`point ${e}`),q("dl",{},...this.colouring.figures(e).flatMap(([s,r])=>[q("dt",{},s),q("dd",{},r)])))}redraw(){this.show(this.shown)}};var Il={number:{title:"point",unit:"",value:i=>i.number},as_built:{title:"as-built accuracy",unit:"%",value:(i,e)=>e?100*e[i.number-1]:null,low:90,high:100},named:{title:"accuracy as designed",unit:"%",value:i=>100*i.named,low:90,high:100},loudest:{title:"level at 100 Hz, loudest microphone",unit:"dB",value:i=>i.loudest},force:{title:"smallest detectable force",unit:"nN",value:i=>1e9*i.force},coverage:{title:"coverage of its area",unit:"%",value:i=>100*i.coverage,high:100}},lu=class{constructor(e){this.changed=e;let t=R("colour-by");t.replaceChildren(...Object.entries(Il).map(([n,{title:s}])=>q("option",{value:n},s))),t.addEventListener("change",()=>{this.chosen=t.value,this.measure(),this.changed()})}changed;points=[];built=null;count=0;chosen="number";low=1;high=1;get wantsBuilt(){return this.chosen==="as_built"}get isByFigure(){return this.chosen!=="number"}take(e){this.points=e.points,this.count=e.points.length,this.measure()}asBuilt(e){this.built=e.per_point,this.measure()}size(e){e!==this.count&&(this.count=e,this.points=[],this.built=null,this.measure())}figures(e){let t=this.points.find(s=>s.number===e);return t?[...Object.entries(Il).filter(([s])=>s!=="number").map(([,s])=>{let r=s.value(t,this.built);return[s.title,r===null?"":`${Ne(r,3)} ${s.unit}`]}),["hardest to tell from",`point ${t.nearest}`]].filter(([,s])=>s):[]}of(e){let t=Il[this.chosen],n=this.points.find(r=>r.number===e),s=this.chosen==="number"?e<=this.count?e:null:n?t.value(n,this.built):null;return s===null?"rgb(128,128,128)":Pl((s-this.low)/(this.high-this.low||1))}measure(){let{value:e,low:t,high:n}=Il[this.chosen];if(this.chosen==="number")[this.low,this.high]=[1,Math.max(this.count,1)];else{let s=this.points.map(r=>e(r,this.built)).filter(r=>r!==null);this.low=Math.min(...s,t??1/0),this.high=Math.max(...s,n??-1/0)}this.legend()}legend(){let{title:e,unit:t}=Il[this.chosen],n=R("legend");n.hidden=!Number.isFinite(this.low)||this.count===0;let s=Array.from({length:9},(a,c)=>Pl(c/8)).join(","),r=q("span",{class:"bar"}),o=a=>`${Ne(a,3)}${t?` ${t}`:""}`;r.style.background=`linear-gradient(to right, ${s})`,n.replaceChildren(q("span",{},e),q("span",{class:"ends"},q("span",{id:"legend-low"},o(this.low)),r,q("span",{id:"legend-high"},o(this.high))))}};var cu=class{compared=[];differences=[];take(e){let t=e.pinned!==null;if(R("compare-empty").hidden=t,R("compare-tables").hidden=!t,!t){this.compared=[],R("compared-figures").replaceChildren();return}R("pinned-name").textContent=e.pinned,this.differences=e.differences??[];let n=this.differences.map(s=>q("tr",{},q("th",{scope:"row"},s.name),q("td",{},Lp(s.there,s.unit)),q("td",{},Lp(s.here,s.unit))));R("differences").replaceChildren(...n.length?n:[q("tr",{},q("td",{colspan:"3"},"no field differs"))])}pinned(e){return this.compared.find(t=>t.name===e)?.there??void 0}rows(){return[["field or figure","unit","pinned","now"],...[...this.differences,...this.compared].map(e=>[e.name,e.unit,Rx(e.there),Rx(e.here)])]}figures(e){this.compared=e,R("compared-figures").replaceChildren(...e.map(t=>q("tr",{title:t.definition,"data-figure":t.name},q("th",{scope:"row"},t.title),q("td",{},t.texts[0]||"\u2013"),q("td",{class:t.better},t.texts[1]||"\u2013"),q("td",{class:t.better},t.better))))}};function Rx(i){return typeof i=="number"?i:Lp(i,"")}function Lp(i,e){return i==null?"\u2013":typeof i=="number"?`${Ne(i,6)}${e?` ${wi(e)}`:""}`:Array.isArray(i)?i.join(", "):String(i)}var EE="uplot",AE="u-hz",RE="u-vt",CE="u-title",PE="u-wrap",IE="u-under",LE="u-over",NE="u-axis",io="u-off",DE="u-select",OE="u-cursor-x",UE="u-cursor-y",FE="u-cursor-pt",kE="u-legend",BE="u-live",zE="u-inline",HE="u-series",VE="u-marker",Cx="u-label",GE="u-value",Nl="width",Dl="height";var Px="bottom",ua="left",Np="right",jp="#000",Ix=jp+"0",Dp="mousemove",Lx="mousedown",Op="mouseup",Nx="mouseenter",Dx="mouseleave",Ox="dblclick",WE="resize",XE="scroll",Ux="change",pu="dppxchange",Zp="--",_a=typeof window<"u",zp=_a?document:null,fa=_a?window:null,qE=_a?navigator:null,Rt,hu;function Hp(){let i=devicePixelRatio;Rt!=i&&(Rt=i,hu&&Gp(Ux,hu,Hp),hu=matchMedia(`(min-resolution: ${Rt-.001}dppx) and (max-resolution: ${Rt+.001}dppx)`),so(Ux,hu,Hp),fa.dispatchEvent(new CustomEvent(pu)))}function Ei(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Vp(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function $t(i,e,t){i.style[e]=t+"px"}function Qi(i,e,t,n){let s=zp.createElement(i);return e!=null&&Ei(s,e),t?.insertBefore(s,n),s}function zi(i,e){return Qi("div",i,e)}var Fx=new WeakMap;function Ms(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Fx.get(i);r!=o&&(i.style.transform=r,Fx.set(i,r),e<0||t<0||e>n||t>s?Ei(i,io):Vp(i,io))}var kx=new WeakMap;function Bx(i,e,t){let n=e+t,s=kx.get(i);n!=s&&(kx.set(i,n),i.style.background=e,i.style.borderColor=t)}var zx=new WeakMap;function Hx(i,e,t,n){let s=e+""+t,r=zx.get(i);s!=r&&(zx.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Jp={passive:!0},$E={...Jp,capture:!0};function so(i,e,t,n){e.addEventListener(i,t,n?$E:Jp)}function Gp(i,e,t,n){e.removeEventListener(i,t,Jp)}_a&&Hp();function es(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:Ai((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function m_(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var g_=i=>i!=null,x_=i=>i!=null&&i>0,xu=m_(g_),YE=m_(x_);function KE(i,e,t,n=0,s=!1){let r=s?YE:xu,o=s?x_:g_;[e,t]=r(i,e,t);let a=i[e],c=i[e];if(e>-1)if(n==1)a=i[e],c=i[t];else if(n==-1)a=i[t],c=i[e];else for(let l=e;l<=t;l++){let h=i[l];o(h)&&(h<a?a=h:h>c&&(c=h))}return[a??zt,c??-zt]}function _u(i,e,t,n){let s=Wx(i),r=Wx(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?js:__,a=s==1?Ai:Hi,c=r==1?Hi:Ai,l=a(o(An(i))),h=c(o(An(e))),u=pa(t,l),d=pa(t,h);return t==10&&(l<0&&(u=Ht(u,-l)),h<0&&(d=Ht(d,-h))),n||t==2?(i=u*s,e=d*r):(i=S_(i,u),e=vu(e,d)),[i,e]}function Qp(i,e,t,n){let s=_u(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var em=.1,Vx={mode:3,pad:em},Ul={pad:0,soft:null,mode:0},jE={min:Ul,max:Ul};function mu(i,e,t,n){return yu(t)?Gx(i,e,t):(Ul.pad=t,Ul.soft=n?0:null,Ul.mode=n?3:0,Gx(i,e,jE))}function Tt(i,e){return i??e}function ZE(i,e,t){for(e=Tt(e,0),t=Tt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Gx(i,e,t){let n=t.min,s=t.max,r=Tt(n.pad,0),o=Tt(s.pad,0),a=Tt(n.hard,-zt),c=Tt(s.hard,zt),l=Tt(n.soft,zt),h=Tt(s.soft,-zt),u=Tt(n.mode,0),d=Tt(s.mode,0),f=e-i,p=js(f),v=oi(An(i),An(e)),g=js(v),m=An(g-p);(f<1e-24||m>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&l!=zt&&(r=0),d==2&&h!=-zt&&(o=0)));let y=f||v||1e3,M=js(y),b=pa(10,Ai(M)),C=y*(f==0?i==0?.1:1:r),A=Ht(S_(i-C,b/10),24),x=i>=l&&(u==1||u==3&&A<=l||u==2&&A>=l)?l:zt,E=oi(a,A<x&&i>=x?x:ts(x,A)),k=y*(f==0?e==0?.1:1:o),D=Ht(vu(e+k,b/10),24),L=e<=h&&(d==1||d==3&&D>=h||d==2&&D<=h)?h:-zt,W=ts(c,D>L&&e<=L?L:oi(L,D));return E==W&&E==0&&(W=100),[E,W]}var JE=new Intl.NumberFormat(_a?qE.language:"en-US"),tm=i=>JE.format(i),Ri=Math,fu=Ri.PI,An=Ri.abs,Ai=Ri.floor,En=Ri.round,Hi=Ri.ceil,ts=Ri.min,oi=Ri.max,pa=Ri.pow,Wx=Ri.sign,js=Ri.log10,__=Ri.log2,QE=(i,e=1)=>Ri.sinh(i)*e,Up=(i,e=1)=>Ri.asinh(i/e),zt=1/0;function Xx(i){return(js((i^i>>31)-(i>>31))|0)+1}function Wp(i,e,t){return ts(oi(i,e),t)}function v_(i){return typeof i=="function"}function St(i){return v_(i)?i:()=>i}var e1=()=>{},y_=i=>i,b_=(i,e)=>e,t1=i=>null,qx=i=>!0,$x=(i,e)=>i==e,n1=/\.\d*?(?=9{6,}|0{6,})/gm,ro=i=>{if(w_(i)||Mr.has(i))return i;let e=`${i}`,t=e.match(n1);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${ro(s)}e${r}`}return Ht(i,n)};function to(i,e){return ro(Ht(ro(i/e))*e)}function vu(i,e){return ro(Hi(ro(i/e))*e)}function S_(i,e){return ro(Ai(ro(i/e))*e)}function Ht(i,e=0){if(w_(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return En(n)/t}var Mr=new Map;function M_(i){return((""+i).split(".")[1]||"").length}function kl(i,e,t,n){let s=[],r=n.map(M_);for(let o=e;o<t;o++){let a=An(o),c=Ht(pa(i,o),a);for(let l=0;l<n.length;l++){let h=i==10?+`${n[l]}e${o}`:n[l]*c,u=(o>=0?0:a)+(o>=r[l]?0:r[l]),d=i==10?h:Ht(h,u);s.push(d),Mr.set(d,u)}}return s}var Fl={},nm=[],ma=[null,null],Sr=Array.isArray,w_=Number.isInteger,i1=i=>i===void 0;function Yx(i){return typeof i=="string"}function yu(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function s1(i){return i!=null&&typeof i=="object"}var r1=Object.getPrototypeOf(Uint8Array),T_="__proto__";function ga(i,e=yu){let t;if(Sr(i)){let n=i.find(s=>s!=null);if(Sr(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=ga(i[s],e)}else t=i.slice()}else if(i instanceof r1)t=i.slice();else if(e(i)){t={};for(let n in i)n!=T_&&(t[n]=ga(i[n],e))}else t=i;return t}function xn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=T_&&(yu(i[s])?xn(i[s],ga(n[s])):i[s]=ga(n[s]))}return i}var o1=0,a1=1,l1=2;function c1(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function h1(i,e){if(f1(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return p1(o[0])||(o=d1(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let c=i[o][0],l=c.length;for(let h=0;h<l;h++)t.add(c[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],c=a[0];for(let l=1;l<a.length;l++){let h=a[l],u=Array(s).fill(void 0),d=e?e[o][l]:a1,f=[];for(let p=0;p<h.length;p++){let v=h[p],g=r.get(c[p]);v===null?d!=o1&&(u[g]=v,d==l1&&f.push(g)):u[g]=v}c1(u,f,s),n.push(u)}}return n}var u1=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function d1(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let c=0;c<t;c++)a[c]=o[n[c]];s.push(a)}return s}function f1(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function p1(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=oi(1,Ai((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let c=i[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var E_=["January","February","March","April","May","June","July","August","September","October","November","December"],A_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function R_(i){return i.slice(0,3)}var m1=A_.map(R_),g1=E_.map(R_),x1={MMMM:E_,MMM:g1,WWWW:A_,WWW:m1};function Ll(i){return(i<10?"0":"")+i}function _1(i){return(i<10?"00":i<100?"0":"")+i}var v1={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Ll(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Ll(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Ll(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Ll(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Ll(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>_1(i.getMilliseconds())};function im(i,e){e=e||x1;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?v1[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var y1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function b1(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==y1?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var C_=i=>i%1==0,gu=[1,2,2.5,5],S1=kl(10,-32,0,gu),P_=kl(10,0,32,gu),M1=P_.filter(C_),no=S1.concat(P_),sm=`
`,I_="{YYYY}",Kx=sm+I_,L_="{M}/{D}",Ol=sm+L_,uu=Ol+"/{YY}",N_="{aa}",w1="{h}:{mm}",da=w1+N_,jx=sm+da,Zx=":{ss}",Pt=null;function D_(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,c=(i==1?kl(10,0,3,gu).filter(C_):kl(10,-3,0,gu)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,I_,Pt,Pt,Pt,Pt,Pt,Pt,1],[s*28,"{MMM}",Kx,Pt,Pt,Pt,Pt,Pt,1],[s,L_,Kx,Pt,Pt,Pt,Pt,Pt,1],[n,"{h}"+N_,uu,Pt,Ol,Pt,Pt,Pt,1],[t,da,uu,Pt,Ol,Pt,Pt,Pt,1],[e,Zx,uu+" "+da,Pt,Ol+" "+da,Pt,jx,Pt,1],[i,Zx+".{fff}",uu+" "+da,Pt,Ol+" "+da,Pt,jx,Pt,1]];function h(u){return(d,f,p,v,g,m)=>{let y=[],M=g>=o,b=g>=r&&g<o,C=u(p),A=Ht(C*i,3),x=Fp(C.getFullYear(),M?0:C.getMonth(),b||M?1:C.getDate()),E=Ht(x*i,3);if(b||M){let k=b?g/r:0,D=M?g/o:0,L=A==E?A:Ht(Fp(x.getFullYear()+D,x.getMonth()+k,1)*i,3),W=new Date(En(L/i)),X=W.getFullYear(),O=W.getMonth();for(let H=0;L<=v;H++){let Y=Fp(X+D*H,O+k*H,1),B=Y-u(Ht(Y*i,3));L=Ht((+Y+B)*i,3),L<=v&&y.push(L)}}else{let k=g>=s?s:g,D=Ai(p)-Ai(A),L=E+D+vu(A-E,k);y.push(L);let W=u(L),X=W.getHours()+W.getMinutes()/t+W.getSeconds()/n,O=g/n,H=d.axes[f]._space,Y=m/H;for(;L=Ht(L+g,i==1?0:3),!(L>v);)if(O>1){let B=Ai(Ht(X+O,6))%24,ee=u(L).getHours()-B;ee>1&&(ee=-1),L-=ee*n,X=(X+O)%24;let se=y[y.length-1];Ht((L-se)/g,3)*Y>=.7&&y.push(L)}else y.push(L)}return y}}return[c,l,h]}var[T1,E1,A1]=D_(1),[R1,C1,P1]=D_(.001);kl(2,-53,53,[1]);function Jx(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Qx(i,e){return(t,n,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],c,l,h,u,d,f;return n.map(p=>{let v=i(p),g=v.getFullYear(),m=v.getMonth(),y=v.getDate(),M=v.getHours(),b=v.getMinutes(),C=v.getSeconds(),A=g!=c&&a[2]||m!=l&&a[3]||y!=h&&a[4]||M!=u&&a[5]||b!=d&&a[6]||C!=f&&a[7]||a[1];return c=g,l=m,h=y,u=M,d=b,f=C,A(v)})}}function I1(i,e){let t=im(e);return(n,s,r,o,a)=>s.map(c=>t(i(c)))}function Fp(i,e,t){return new Date(i,e,t)}function e_(i,e){return e(i)}var L1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function t_(i,e){return(t,n,s,r)=>r==null?Zp:e(i(n))}function N1(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function D1(i,e){return i.series[e].fill(i,e)}var O1={show:!0,live:!0,isolate:!1,mount:e1,markers:{show:!0,width:2,stroke:N1,fill:D1,dash:"solid"},idx:null,idxs:null,values:[]};function U1(i,e){let t=i.cursor.points,n=zi(),s=t.size(i,e);$t(n,Nl,s),$t(n,Dl,s);let r=s/-2;$t(n,"marginLeft",r),$t(n,"marginTop",r);let o=t.width(i,e,s);return o&&$t(n,"borderWidth",o),n}function F1(i,e){let t=i.series[e].points;return t._fill||t._stroke}function k1(i,e){let t=i.series[e].points;return t._stroke||t._fill}function B1(i,e){return i.series[e].points.size}var kp=[0,0];function z1(i,e,t){return kp[0]=e,kp[1]=t,kp}function du(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Bp(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var H1={show:!0,x:!0,y:!0,lock:!1,move:z1,points:{one:!1,show:U1,size:B1,width:0,stroke:k1,fill:F1},bind:{mousedown:du,mouseup:du,click:du,dblclick:du,mousemove:Bp,mouseleave:Bp,mouseenter:Bp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},O_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},rm=xn({},O_,{filter:b_}),U_=xn({},rm,{size:10}),F_=xn({},O_,{show:!1}),om='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',k_="bold "+om,B_=1.5,n_={show:!0,scale:"x",stroke:jp,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:k_,side:2,grid:rm,ticks:U_,border:F_,font:om,lineGap:B_,rotate:0},V1="Value",G1="Time",i_={show:!0,scale:"x",auto:!1,sorted:1,min:zt,max:-zt,idxs:[]};function W1(i,e,t,n,s){return e.map(r=>r==null?"":tm(r))}function X1(i,e,t,n,s,r,o){let a=[],c=Mr.get(s)||0;t=o?t:Ht(vu(t,s),c);for(let l=t;l<=n;l=Ht(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function Xp(i,e,t,n,s,r,o){let a=[],c=i.scales[i.axes[e].scale].log,l=c==10?js:__,h=Ai(l(t));s=pa(c,h),c==10&&(s=no[es(s,no)]);let u=t,d=s*c;c==10&&(d=no[es(d,no)]);do a.push(u),u=u+s,c==10&&!Mr.has(u)&&(u=Ht(u,Mr.get(s))),u>=d&&(s=u,d=s*c,c==10&&(d=no[es(d,no)]));while(u<=n);return a}function q1(i,e,t,n,s,r,o){let c=i.scales[i.axes[e].scale].asinh,l=n>c?Xp(i,e,oi(c,t),n,s):[c],h=n>=0&&t<=0?[0]:[];return(t<-c?Xp(i,e,oi(c,-n),-t,s):[c]).reverse().map(d=>-d).concat(h,l)}var z_=/./,$1=/[12357]/,Y1=/[125]/,s_=/1/,qp=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function K1(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],c=i.valToPos,l=r._space,h=c(10,o),u=c(9,o)-h>=l?z_:c(7,o)-h>=l?$1:c(5,o)-h>=l?Y1:s_;if(u==s_){let d=An(c(1,o)-h);if(d<l)return qp(e.slice().reverse(),a.distr,u,Hi(l/d)).reverse()}return qp(e,a.distr,u,1)}function j1(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,c=i.valToPos,l=An(c(1,o)-c(2,o));return l<a?qp(e.slice().reverse(),3,z_,Hi(a/l)).reverse():e}function Z1(i,e,t,n){return n==null?Zp:e==null?"":tm(e)}var r_={show:!0,scale:"y",stroke:jp,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:k_,side:3,grid:rm,ticks:U_,border:F_,font:om,lineGap:B_,rotate:0};function J1(i,e){let t=3+(i||1)*2;return Ht(t*e,3)}function Q1(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=An(o-r),c=i.series[e],l=a/(c.points.space*Rt);return n[1]-n[0]<=l}var o_={scale:null,auto:!0,sorted:0,min:zt,max:-zt},H_=(i,e,t,n,s)=>s,a_={show:!0,auto:!0,sorted:0,gaps:H_,alpha:1,facets:[xn({},o_,{scale:"x"}),xn({},o_,{scale:"y"})]},l_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:H_,alpha:1,points:{show:Q1,filter:null},values:null,min:zt,max:-zt,idxs:[],path:null,clip:null};function eA(i,e,t,n,s){return t/10}var V_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},tA=xn({},V_,{time:!1,ori:1}),c_={};function G_(i,e){let t=c_[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,c,l){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,c,l)}},i!=null&&(c_[i]=t)),t}var xa=1,$p=2;function oo(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,c=r[0],l=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,v=a.height,g=i.valToPosH,m=i.valToPosV;return h.ori==0?t(s,c,l,h,u,g,m,d,f,p,v,Su,va,wu,X_,$_):t(s,c,l,h,u,m,g,f,d,v,p,Mu,ya,cm,q_,Y_)}function am(i,e){let t=0,n=0,s=Tt(i.bands,nm);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function nA(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,c=i.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function Zs(i,e,t,n,s,r){return oo(i,e,(o,a,c,l,h,u,d,f,p,v,g)=>{let m=o.pxRound,y=l.dir*(l.ori==0?1:-1),M=l.ori==0?va:ya,b,C;y==1?(b=t,C=n):(b=n,C=t);let A=m(u(a[b],l,v,f)),x=m(d(c[b],h,g,p)),E=m(u(a[C],l,v,f)),k=m(d(r==1?h.max:h.min,h,g,p)),D=new Path2D(s);return M(D,E,k),M(D,A,k),M(D,A,x),D})}function bu(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?wu:cm,c=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-c;f>0&&a(o,c,n,f,n+r),c=d[1]}}let l=t+s-c,h=10;l>0&&a(o,c,n-h/2,l,n+r+h)}return o}function iA(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function lm(i,e,t,n,s,r,o){let a=[],c=i.length;for(let l=s==1?t:n;l>=t&&l<=n;l+=s)if(e[l]===null){let u=l,d=l;if(s==1)for(;++l<=n&&e[l]===null;)d=l;else for(;--l>=t&&e[l]===null;)d=l;let f=r(i[u]),p=d==u?f:r(i[d]),v=u-s;f=o<=0&&v>=0&&v<c?r(i[v]):f;let m=d+s;p=o>=0&&m>=0&&m<c?r(i[m]):p,p>=f&&a.push([f,p])}return a}function h_(i){return i==0?y_:i==1?En:e=>to(e,i)}function W_(i){let e=i==0?Su:Mu,t=i==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},n=i==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,h=0)=>{l==0&&h==0?n(s,r,o,a,c):(l=ts(l,a/2,c/2),h=ts(h,a/2,c/2),e(s,r+l,o),t(s,r+a,o,r+a,o+c,l),t(s,r+a,o+c,r,o+c,h),t(s,r,o+c,r,o,h),t(s,r,o,r+a,o,l),s.closePath())}}var Su=(i,e,t)=>{i.moveTo(e,t)},Mu=(i,e,t)=>{i.moveTo(t,e)},va=(i,e,t)=>{i.lineTo(e,t)},ya=(i,e,t)=>{i.lineTo(t,e)},wu=W_(0),cm=W_(1),X_=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},q_=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},$_=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Y_=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function K_(i){return(e,t,n,s,r)=>oo(e,t,(o,a,c,l,h,u,d,f,p,v,g)=>{let{pxRound:m,points:y}=o,M,b;l.ori==0?(M=Su,b=X_):(M=Mu,b=q_);let C=Ht(y.width*Rt,3),A=(y.size-y.width)/2*Rt,x=Ht(A*2,3),E=new Path2D,k=new Path2D,{left:D,top:L,width:W,height:X}=e.bbox;wu(k,D-x,L-x,W+x*2,X+x*2);let O=H=>{if(c[H]!=null){let Y=m(u(a[H],l,v,f)),B=m(d(c[H],h,g,p));M(E,Y+A,B),b(E,Y,B,A,0,fu*2)}};if(r)r.forEach(O);else for(let H=n;H<=s;H++)O(H);return{stroke:C>0?E:null,fill:E,clip:k,flags:xa|$p}})}function j_(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var sA=j_(va),rA=j_(ya);function Z_(i){let e=Tt(i?.alignGaps,0);return(t,n,s,r)=>oo(t,n,(o,a,c,l,h,u,d,f,p,v,g)=>{[s,r]=xu(c,s,r);let m=o.pxRound,y=X=>m(u(X,l,v,f)),M=X=>m(d(X,h,g,p)),b,C;l.ori==0?(b=va,C=sA):(b=ya,C=rA);let A=l.dir*(l.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:xa},E=x.stroke,k=!1;if(r-s>=v*4){let X=de=>t.posToVal(de,l.key,!0),O=null,H=null,Y,B,ce,Z=y(a[A==1?s:r]),ee=y(a[s]),se=y(a[r]),fe=X(A==1?ee+1:se-1);for(let de=A==1?s:r;de>=s&&de<=r;de+=A){let te=a[de],ve=(A==1?te<fe:te>fe)?Z:y(te),Ce=c[de];ve==Z?Ce!=null?(B=Ce,O==null?(b(E,ve,M(B)),Y=O=H=B):B<O?O=B:B>H&&(H=B)):Ce===null&&(k=!0):(O!=null&&C(E,Z,M(O),M(H),M(Y),M(B)),Ce!=null?(B=Ce,b(E,ve,M(B)),O=H=Y=B):(O=H=null,Ce===null&&(k=!0)),Z=ve,fe=X(Z+A))}O!=null&&O!=H&&ce!=Z&&C(E,Z,M(O),M(H),M(Y),M(B))}else for(let X=A==1?s:r;X>=s&&X<=r;X+=A){let O=c[X];O===null?k=!0:O!=null&&b(E,y(a[X]),M(O))}let[L,W]=am(t,n);if(o.fill!=null||L!=0){let X=x.fill=new Path2D(E),O=o.fillTo(t,n,o.min,o.max,L),H=M(O),Y=y(a[s]),B=y(a[r]);A==-1&&([B,Y]=[Y,B]),b(X,B,H),b(X,Y,H)}if(!o.spanGaps){let X=[];k&&X.push(...lm(a,c,s,r,A,y,e)),x.gaps=X=o.gaps(t,n,s,r,X),x.clip=bu(X,l.ori,f,p,v,g)}return W!=0&&(x.band=W==2?[Zs(t,n,s,r,E,-1),Zs(t,n,s,r,E,1)]:Zs(t,n,s,r,E,W)),x})}function oA(i){let e=Tt(i.align,1),t=Tt(i.ascDesc,!1),n=Tt(i.alignGaps,0),s=Tt(i.extend,!1);return(r,o,a,c)=>oo(r,o,(l,h,u,d,f,p,v,g,m,y,M)=>{[a,c]=xu(u,a,c);let b=l.pxRound,{left:C,width:A}=r.bbox,x=ee=>b(p(ee,d,y,g)),E=ee=>b(v(ee,f,M,m)),k=d.ori==0?va:ya,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:xa},L=D.stroke,W=d.dir*(d.ori==0?1:-1),X=E(u[W==1?a:c]),O=x(h[W==1?a:c]),H=O,Y=O;s&&e==-1&&(Y=C,k(L,Y,X)),k(L,O,X);for(let ee=W==1?a:c;ee>=a&&ee<=c;ee+=W){let se=u[ee];if(se==null)continue;let fe=x(h[ee]),de=E(se);e==1?k(L,fe,X):k(L,H,de),k(L,fe,de),X=de,H=fe}let B=H;s&&e==1&&(B=C+A,k(L,B,X));let[ce,Z]=am(r,o);if(l.fill!=null||ce!=0){let ee=D.fill=new Path2D(L),se=l.fillTo(r,o,l.min,l.max,ce),fe=E(se);k(ee,B,fe),k(ee,Y,fe)}if(!l.spanGaps){let ee=[];ee.push(...lm(h,u,a,c,W,x,n));let se=l.width*Rt/2,fe=t||e==1?se:-se,de=t||e==-1?-se:se;ee.forEach(te=>{te[0]+=fe,te[1]+=de}),D.gaps=ee=l.gaps(r,o,a,c,ee),D.clip=bu(ee,d.ori,g,m,y,M)}return Z!=0&&(D.band=Z==2?[Zs(r,o,a,c,L,-1),Zs(r,o,a,c,L,1)]:Zs(r,o,a,c,L,Z)),D})}function u_(i,e,t,n,s,r,o=zt){if(i.length>1){let a=null;for(let c=0,l=1/0;c<i.length;c++)if(e[c]!==void 0){if(a!=null){let h=An(i[c]-i[a]);h<l&&(l=h,o=An(t(i[c],n,s,r)-t(i[a],n,s,r)))}a=c}}return o}function aA(i){i=i||Fl;let e=Tt(i.size,[.6,zt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=St(s),o=1-e[0],a=Tt(e[1],zt),c=Tt(e[2],1),l=Tt(i.disp,Fl),h=Tt(i.each,f=>{}),{fill:u,stroke:d}=l;return(f,p,v,g)=>oo(f,p,(m,y,M,b,C,A,x,E,k,D,L)=>{let W=m.pxRound,X=t,O=n*Rt,H=a*Rt,Y=c*Rt,B,ce;b.ori==0?[B,ce]=r(f,p):[ce,B]=r(f,p);let Z=b.dir*(b.ori==0?1:-1),ee=b.ori==0?wu:cm,se=b.ori==0?h:(Ie,Je,lt,we,kt,Ge,Ze)=>{h(Ie,Je,lt,kt,we,Ze,Ge)},fe=Tt(f.bands,nm).find(Ie=>Ie.series[0]==p),de=fe!=null?fe.dir:0,te=m.fillTo(f,p,m.min,m.max,de),ge=W(x(te,C,L,k)),ve,Ce,Me,$e=D,at=W(m.width*Rt),We=!1,pt=null,ut=null,rt=null,Yt=null;u!=null&&(at==0||d!=null)&&(We=!0,pt=u.values(f,p,v,g),ut=new Map,new Set(pt).forEach(Ie=>{Ie!=null&&ut.set(Ie,new Path2D)}),at>0&&(rt=d.values(f,p,v,g),Yt=new Map,new Set(rt).forEach(Ie=>{Ie!=null&&Yt.set(Ie,new Path2D)})));let{x0:Vt,size:hn}=l;if(Vt!=null&&hn!=null){X=1,y=Vt.values(f,p,v,g),Vt.unit==2&&(y=y.map(lt=>f.posToVal(E+lt*D,b.key,!0)));let Ie=hn.values(f,p,v,g);hn.unit==2?Ce=Ie[0]*D:Ce=A(Ie[0],b,D,E)-A(0,b,D,E),$e=u_(y,M,A,b,D,E,$e),Me=$e-Ce+O}else $e=u_(y,M,A,b,D,E,$e),Me=$e*o+O,Ce=$e-Me;Me<1&&(Me=0),at>=Ce/2&&(at=0),Me<5&&(W=y_);let Ot=Me>0,Pn=$e-Me-(Ot?at:0);Ce=W(Wp(Pn,Y,H)),ve=(X==0?Ce/2:X==Z?0:Ce)-X*Z*((X==0?O/2:0)+(Ot?at/2:0));let Mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},_n=We?null:new Path2D,en=null;if(fe!=null)en=f.data[fe.series[1]];else{let{y0:Ie,y1:Je}=l;Ie!=null&&Je!=null&&(M=Je.values(f,p,v,g),en=Ie.values(f,p,v,g))}let un=B*Ce,F=ce*Ce;for(let Ie=Z==1?v:g;Ie>=v&&Ie<=g;Ie+=Z){let Je=M[Ie];if(Je==null)continue;if(en!=null){let $=en[Ie]??0;if(Je-$==0)continue;ge=x($,C,L,k)}let lt=b.distr!=2||l!=null?y[Ie]:Ie,we=A(lt,b,D,E),kt=x(Tt(Je,te),C,L,k),Ge=W(we-ve),Ze=W(oi(kt,ge)),P=W(ts(kt,ge)),S=Ze-P;if(Je!=null){let $=Je<0?F:un,ue=Je<0?un:F;We?(at>0&&rt[Ie]!=null&&ee(Yt.get(rt[Ie]),Ge,P+Ai(at/2),Ce,oi(0,S-at),$,ue),pt[Ie]!=null&&ee(ut.get(pt[Ie]),Ge,P+Ai(at/2),Ce,oi(0,S-at),$,ue)):ee(_n,Ge,P+Ai(at/2),Ce,oi(0,S-at),$,ue),se(f,p,Ie,Ge-at/2,P,Ce+at,S)}}return at>0?Mt.stroke=We?Yt:_n:We||(Mt._fill=m.width==0?m._fill:m._stroke??m._fill,Mt.width=0),Mt.fill=We?ut:_n,Mt})}function lA(i,e){let t=Tt(e?.alignGaps,0);return(n,s,r,o)=>oo(n,s,(a,c,l,h,u,d,f,p,v,g,m)=>{[r,o]=xu(l,r,o);let y=a.pxRound,M=B=>y(d(B,h,g,p)),b=B=>y(f(B,u,m,v)),C,A,x;h.ori==0?(C=Su,x=va,A=$_):(C=Mu,x=ya,A=Y_);let E=h.dir*(h.ori==0?1:-1),k=M(c[E==1?r:o]),D=k,L=[],W=[];for(let B=E==1?r:o;B>=r&&B<=o;B+=E)if(l[B]!=null){let Z=c[B],ee=M(Z);L.push(D=ee),W.push(b(l[B]))}let X={stroke:i(L,W,C,x,A,y),fill:null,clip:null,band:null,gaps:null,flags:xa},O=X.stroke,[H,Y]=am(n,s);if(a.fill!=null||H!=0){let B=X.fill=new Path2D(O),ce=a.fillTo(n,s,a.min,a.max,H),Z=b(ce);x(B,D,Z),x(B,k,Z)}if(!a.spanGaps){let B=[];B.push(...lm(c,l,r,o,E,M,t)),X.gaps=B=a.gaps(n,s,r,o,B),X.clip=bu(B,h.ori,p,v,g,m)}return Y!=0&&(X.band=Y==2?[Zs(n,s,r,o,O,-1),Zs(n,s,r,o,O,1)]:Zs(n,s,r,o,O,Y)),X})}function cA(i){return lA(hA,i)}function hA(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let c=Array(o),l=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],l[d]=h[d]/u[d];c[0]=l[0];for(let d=1;d<o-1;d++)l[d]===0||l[d-1]===0||l[d-1]>0!=l[d]>0?c[d]=0:(c[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/l[d-1]+(u[d]+2*u[d-1])/l[d]),isFinite(c[d])||(c[d]=0));c[o-1]=l[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+c[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-c[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var Yp=new Set;function d_(){for(let i of Yp)i.syncRect(!0)}_a&&(so(WE,fa,d_),so(XE,fa,d_,!0),so(pu,fa,()=>{Gn.pxRatio=Rt}));var uA=Z_(),dA=K_();function f_(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Kp(r,o,e,t))}function fA(i,e){return i.map((t,n)=>n==0?{}:xn({},e,t))}function Kp(i,e,t,n){return xn({},e==0?t:n,i)}function J_(i,e,t){return e==null?ma:[e,t]}var pA=J_;function mA(i,e,t){return e==null?ma:mu(e,t,em,!0)}function Q_(i,e,t,n){return e==null?ma:_u(e,t,i.scales[n].log,!1)}var gA=Q_;function ev(i,e,t,n){return e==null?ma:Qp(e,t,i.scales[n].log,!1)}var xA=ev;function _A(i,e,t,n,s){let r=oi(Xx(i),Xx(e)),o=e-i,a=es(s/n*o,t);do{let c=t[a],l=n*c/o;if(l>=s&&r+(c<5?Mr.get(c):0)<=17)return[c,l]}while(++a<t.length);return[0,0]}function p_(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=En((t=+s)*Rt))+"px"),[i,e,t]}function vA(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Ht(e[2]*Rt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Gn(i,e,t){let n={mode:Tt(i.mode,1)},s=n.mode;function r(_,w,I,N){let G=w.valToPct(_);return N+I*(w.dir==-1?1-G:G)}function o(_,w,I,N){let G=w.valToPct(_);return N+I*(w.dir==-1?G:1-G)}function a(_,w,I,N){return w.ori==0?r(_,w,I,N):o(_,w,I,N)}n.valToPosH=r,n.valToPosV=o;let c=!1;n.status=0;let l=n.root=zi(EE);if(i.id!=null&&(l.id=i.id),Ei(l,i.class),i.title){let _=zi(CE,l);_.textContent=i.title}let h=Qi("canvas"),u=n.ctx=h.getContext("2d"),d=zi(PE,l);so("click",d,_=>{_.target===p&&(Wt!=mo||Kt!=go)&&Bn.click(n,_)},!0);let f=n.under=zi(IE,d);d.appendChild(h);let p=n.over=zi(LE,d);i=ga(i);let v=+Tt(i.pxAlign,1),g=h_(v);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let m=i.ms||.001,y=n.series=s==1?f_(i.series||[],i_,l_,!1):fA(i.series||[null],a_),M=n.axes=f_(i.axes||[],n_,r_,!0),b=n.scales={},C=n.bands=i.bands||[];C.forEach(_=>{_.fill=St(_.fill||null),_.dir=Tt(_.dir,-1)});let A=s==2?y[1].facets[0].scale:y[0].scale,x={axes:Rs,series:vt},E=(i.drawOrder||["axes","series"]).map(_=>x[_]);function k(_){let w=_.distr==3?I=>js(I>0?I:_.clamp(n,I,_.min,_.max,_.key)):_.distr==4?I=>Up(I,_.asinh):_.distr==100?I=>_.fwd(I):I=>I;return I=>{let N=w(I),{_min:G,_max:J}=_,le=J-G;return(N-G)/le}}function D(_){let w=b[_];if(w==null){let I=(i.scales||Fl)[_]||Fl;if(I.from!=null){D(I.from);let N=xn({},b[I.from],I,{key:_});N.valToPct=k(N),b[_]=N}else{w=b[_]=xn({},_==A?V_:tA,I),w.key=_;let N=w.time,G=w.range,J=Sr(G);if((_!=A||s==2&&!N)&&(J&&(G[0]==null||G[1]==null)&&(G={min:G[0]==null?Vx:{mode:1,hard:G[0],soft:G[0]},max:G[1]==null?Vx:{mode:1,hard:G[1],soft:G[1]}},J=!1),!J&&yu(G))){let le=G;G=(pe,be,Ue)=>be==null?ma:mu(be,Ue,le)}w.range=St(G||(N?pA:_==A?w.distr==3?gA:w.distr==4?xA:J_:w.distr==3?Q_:w.distr==4?ev:mA)),w.auto=St(J?!1:w.auto),w.clamp=St(w.clamp||eA),w._min=w._max=null,w.valToPct=k(w)}}}D("x"),D("y"),s==1&&y.forEach(_=>{D(_.scale)}),M.forEach(_=>{D(_.scale)});for(let _ in i.scales)D(_);let L=b[A],W=L.distr,X,O;L.ori==0?(Ei(l,AE),X=r,O=o):(Ei(l,RE),X=o,O=r);let H={};for(let _ in b){let w=b[_];(w.min!=null||w.max!=null)&&(H[_]={min:w.min,max:w.max},w.min=w.max=null)}let Y=i.tzDate||(_=>new Date(En(_/m))),B=i.fmtDate||im,ce=m==1?A1(Y):P1(Y),Z=Qx(Y,Jx(m==1?E1:C1,B)),ee=t_(Y,e_(L1,B)),se=[],fe=n.legend=xn({},O1,i.legend),de=n.cursor=xn({},H1,{drag:{y:s==2}},i.cursor),te=fe.show,ge=de.show,ve=fe.markers;fe.idxs=se,ve.width=St(ve.width),ve.dash=St(ve.dash),ve.stroke=St(ve.stroke),ve.fill=St(ve.fill);let Ce,Me,$e,at=[],We=[],pt,ut=!1,rt={};if(fe.live){let _=y[1]?y[1].values:null;ut=_!=null,pt=ut?_(n,1,0):{_:0};for(let w in pt)rt[w]=Zp}if(te)if(Ce=Qi("table",kE,l),$e=Qi("tbody",null,Ce),fe.mount(n,Ce),ut){Me=Qi("thead",null,Ce,$e);let _=Qi("tr",null,Me);Qi("th",null,_);for(var Yt in pt)Qi("th",Cx,_).textContent=Yt}else Ei(Ce,zE),fe.live&&Ei(Ce,BE);let Vt={show:!0},hn={show:!1};function Ot(_,w){if(w==0&&(ut||!fe.live||s==2))return ma;let I=[],N=Qi("tr",HE,$e,$e.childNodes[w]);Ei(N,_.class),_.show||Ei(N,io);let G=Qi("th",null,N);if(ve.show){let pe=zi(VE,G);if(w>0){let be=ve.width(n,w);be&&(pe.style.border=be+"px "+ve.dash(n,w)+" "+ve.stroke(n,w)),pe.style.background=ve.fill(n,w)}}let J=zi(Cx,G);_.label instanceof HTMLElement?J.appendChild(_.label):J.textContent=_.label,w>0&&(ve.show||(J.style.color=_.width>0?ve.stroke(n,w):ve.fill(n,w)),Mt("click",G,pe=>{if(de._lock)return;et(pe);let be=y.indexOf(_);if((pe.ctrlKey||pe.metaKey)!=fe.isolate){let Ue=y.some((Fe,Be)=>Be>0&&Be!=be&&Fe.show);y.forEach((Fe,Be)=>{Be>0&&as(Be,Ue?Be==be?Vt:hn:Vt,!0,mn.setSeries)})}else as(be,{show:!_.show},!0,mn.setSeries)},!1),tt&&Mt(Nx,G,pe=>{de._lock||(et(pe),as(y.indexOf(_),_o,!0,mn.setSeries))},!1));for(var le in pt){let pe=Qi("td",GE,N);pe.textContent="--",I.push(pe)}return[N,I]}let Pn=new Map;function Mt(_,w,I,N=!0){let G=Pn.get(w)||{},J=de.bind[_](n,w,I,N);J&&(so(_,w,G[_]=J),Pn.set(w,G))}function _n(_,w,I){let N=Pn.get(w)||{};for(let G in N)(_==null||G==_)&&(Gp(G,w,N[G]),delete N[G]);_==null&&Pn.delete(w)}let en=0,un=0,F=0,Ie=0,Je=0,lt=0,we=Je,kt=lt,Ge=F,Ze=Ie,P=0,S=0,$=0,ue=0;n.bbox={};let ae=!1,_e=!1,ye=!1,ne=!1,re=!1,me=!1;function U(_,w,I){(I||_!=n.width||w!=n.height)&&oe(_,w),dt(!1),ye=!0,_e=!0,Xn()}function oe(_,w){n.width=en=F=_,n.height=un=Ie=w,Je=lt=0,Se(),Xe();let I=n.bbox;P=I.left=to(Je*Rt,.5),S=I.top=to(lt*Rt,.5),$=I.width=to(F*Rt,.5),ue=I.height=to(Ie*Rt,.5)}let ie=3;function Te(){let _=!1,w=0;for(;!_;){w++;let I=uo(w),N=os(w);_=w==ie||I&&N,_||(oe(n.width,n.height),_e=!0)}}function xe({width:_,height:w}){U(_,w)}n.setSize=xe;function Se(){let _=!1,w=!1,I=!1,N=!1;M.forEach((G,J)=>{if(G.show&&G._show){let{side:le,_size:pe}=G,be=le%2,Ue=G.label!=null?G.labelSize:0,Fe=pe+Ue;Fe>0&&(be?(F-=Fe,le==3?(Je+=Fe,N=!0):I=!0):(Ie-=Fe,le==0?(lt+=Fe,_=!0):w=!0))}}),ss[0]=_,ss[1]=I,ss[2]=w,ss[3]=N,F-=Gi[1]+Gi[3],Je+=Gi[3],Ie-=Gi[2]+Gi[0],lt+=Gi[0]}function Xe(){let _=Je+F,w=lt+Ie,I=Je,N=lt;function G(J,le){switch(J){case 1:return _+=le,_-le;case 2:return w+=le,w-le;case 3:return I-=le,I+le;case 0:return N-=le,N+le}}M.forEach((J,le)=>{if(J.show&&J._show){let pe=J.side;J._pos=G(pe,J._size),J.label!=null&&(J._lpos=G(pe,J.labelSize))}})}if(de.dataIdx==null){let _=de.hover,w=_.skip=new Set(_.skip??[]);w.add(void 0);let I=_.prox=St(_.prox),N=_.bias??=0;de.dataIdx=(G,J,le,pe)=>{if(J==0)return le;let be=le,Ue=I(G,J,le,pe)??zt,Fe=Ue>=0&&Ue<zt,Be=L.ori==0?F:Ie,ot=de.left,Et=e[0],wt=e[J];if(w.has(wt[le])){be=null;let yt=null,Qe=null,Ye;if(N==0||N==-1)for(Ye=le;yt==null&&Ye-- >0;)w.has(wt[Ye])||(yt=Ye);if(N==0||N==1)for(Ye=le;Qe==null&&Ye++<wt.length;)w.has(wt[Ye])||(Qe=Ye);if(yt!=null||Qe!=null)if(Fe){let qt=yt==null?-1/0:X(Et[yt],L,Be,0),sn=Qe==null?1/0:X(Et[Qe],L,Be,0),Dn=ot-qt,Ut=sn-ot;Dn<=Ut?Dn<=Ue&&(be=yt):Ut<=Ue&&(be=Qe)}else be=Qe==null?yt:yt==null?Qe:le-yt<=Qe-le?yt:Qe}else Fe&&An(ot-X(Et[le],L,Be,0))>Ue&&(be=null);return be}}let et=_=>{de.event=_};de.idxs=se,de._lock=!1;let he=de.points;he.show=St(he.show),he.size=St(he.size),he.stroke=St(he.stroke),he.width=St(he.width),he.fill=St(he.fill);let ze=n.focus=xn({},i.focus||{alpha:.3},de.focus),tt=ze.prox>=0,Pe=tt&&he.one,ht=[],Gt=[],jn=[];function Ea(_,w){let I=he.show(n,w);if(I instanceof HTMLElement)return Ei(I,FE),Ei(I,_.class),Ms(I,-10,-10,F,Ie),p.insertBefore(I,ht[w]),I}function lo(_,w){if(s==1||w>0){let I=s==1&&b[_.scale].time,N=_.value;_.value=I?Yx(N)?t_(Y,e_(N,B)):N||ee:N||Z1,_.label=_.label||(I?G1:V1)}if(Pe||w>0){_.width=_.width==null?1:_.width,_.paths=_.paths||uA||t1,_.fillTo=St(_.fillTo||nA),_.pxAlign=+Tt(_.pxAlign,v),_.pxRound=h_(_.pxAlign),_.stroke=St(_.stroke||null),_.fill=St(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let I=J1(oi(1,_.width),1),N=_.points=xn({},{size:I,width:oi(1,I*.2),stroke:_.stroke,space:I*2,paths:dA,_stroke:null,_fill:null},_.points);N.show=St(N.show),N.filter=St(N.filter),N.fill=St(N.fill),N.stroke=St(N.stroke),N.paths=St(N.paths),N.pxAlign=_.pxAlign}if(te){let I=Ot(_,w);at.splice(w,0,I[0]),We.splice(w,0,I[1]),fe.values.push(null)}if(ge){se.splice(w,0,null);let I=null;Pe?w==0&&(I=Ea(_,w)):w>0&&(I=Ea(_,w)),ht.splice(w,0,I),Gt.splice(w,0,0),jn.splice(w,0,0)}Nn("addSeries",w)}function ad(_,w){w=w??y.length,_=s==1?Kp(_,w,i_,l_):Kp(_,w,{},a_),y.splice(w,0,_),lo(y[w],w)}n.addSeries=ad;function ec(_){if(y.splice(_,1),te){fe.values.splice(_,1),We.splice(_,1);let w=at.splice(_,1)[0];_n(null,w.firstChild),w.remove()}ge&&(se.splice(_,1),ht.splice(_,1)[0].remove(),Gt.splice(_,1),jn.splice(_,1)),Nn("delSeries",_)}n.delSeries=ec;let ss=[!1,!1,!1,!1];function Ts(_,w){if(_._show=_.show,_.show){let I=_.side%2,N=b[_.scale];N==null&&(_.scale=I?y[1].scale:A,N=b[_.scale]);let G=N.time;_.size=St(_.size),_.space=St(_.space),_.rotate=St(_.rotate),Sr(_.incrs)&&_.incrs.forEach(le=>{!Mr.has(le)&&Mr.set(le,M_(le))}),_.incrs=St(_.incrs||(N.distr==2?M1:G?m==1?T1:R1:no)),_.splits=St(_.splits||(G&&N.distr==1?ce:N.distr==3?Xp:N.distr==4?q1:X1)),_.stroke=St(_.stroke),_.grid.stroke=St(_.grid.stroke),_.ticks.stroke=St(_.ticks.stroke),_.border.stroke=St(_.border.stroke);let J=_.values;_.values=Sr(J)&&!Sr(J[0])?St(J):G?Sr(J)?Qx(Y,Jx(J,B)):Yx(J)?I1(Y,J):J||Z:J||W1,_.filter=St(_.filter||(N.distr>=3&&N.log==10?K1:N.distr==3&&N.log==2?j1:b_)),_.font=p_(_.font),_.labelFont=p_(_.labelFont),_._size=_.size(n,null,w,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(ss[w]=!0,_._el=zi(NE,d))}}function Es(_,w,I,N){let[G,J,le,pe]=I,be=w%2,Ue=0;return be==0&&(pe||J)&&(Ue=w==0&&!G||w==2&&!le?En(n_.size/3):0),be==1&&(G||le)&&(Ue=w==1&&!J||w==3&&!pe?En(r_.size/2):0),Ue}let Aa=n.padding=(i.padding||[Es,Es,Es,Es]).map(_=>St(Tt(_,Es))),Gi=n._padding=Aa.map((_,w)=>_(n,w,ss,0)),tn,on=null,an=null,rs=s==1?y[0].idxs:null,gi=null,er=!1;function Ra(_,w){if(e=_??[],n.data=n._data=e,s==2){tn=0;for(let I=1;I<y.length;I++)tn+=e[I][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),gi=e[0],tn=gi.length;let I=e;if(W==2){I=e.slice();let N=I[0]=Array(tn);for(let G=0;G<tn;G++)N[G]=G}n._data=e=I}if(dt(!0),Nn("setData"),W==2&&(ye=!0),w!==!1){let I=L;I.auto(n,er)?Ca():ir(A,I.min,I.max),ne=ne||de.left>=0,me=!0,Xn()}}n.setData=Ra;function Ca(){er=!0;let _,w;s==1&&(tn>0?(on=rs[0]=0,an=rs[1]=tn-1,_=e[0][on],w=e[0][an],W==2?(_=on,w=an):_==w&&(W==3?[_,w]=_u(_,_,L.log,!1):W==4?[_,w]=Qp(_,_,L.log,!1):L.time?w=_+En(86400/m):[_,w]=mu(_,w,em,!0))):(on=rs[0]=_=null,an=rs[1]=w=null)),ir(A,_,w)}let co,tr,ho,T,z,Q,K,j,Ee,Le;function Ae(_,w,I,N,G,J){_??=Ix,I??=nm,N??="butt",G??=Ix,J??="round",_!=co&&(u.strokeStyle=co=_),G!=tr&&(u.fillStyle=tr=G),w!=ho&&(u.lineWidth=ho=w),J!=z&&(u.lineJoin=z=J),N!=Q&&(u.lineCap=Q=N),I!=T&&u.setLineDash(T=I)}function De(_,w,I,N){w!=tr&&(u.fillStyle=tr=w),_!=K&&(u.font=K=_),I!=j&&(u.textAlign=j=I),N!=Ee&&(u.textBaseline=Ee=N)}function Ve(_,w,I,N,G=0){if(N.length>0&&_.auto(n,er)&&(w==null||w.min==null)){let J=Tt(on,0),le=Tt(an,N.length-1),pe=I.min==null?KE(N,J,le,G,_.distr==3):[I.min,I.max];_.min=ts(_.min,I.min=pe[0]),_.max=oi(_.max,I.max=pe[1])}}let it={min:null,max:null};function _t(){for(let N in b){let G=b[N];H[N]==null&&(G.min==null||H[A]!=null&&G.auto(n,er))&&(H[N]=it)}for(let N in b){let G=b[N];H[N]==null&&G.from!=null&&H[G.from]!=null&&(H[N]=it)}H[A]!=null&&dt(!0);let _={};for(let N in H){let G=H[N];if(G!=null){let J=_[N]=ga(b[N],s1);if(G.min!=null)xn(J,G);else if(N!=A||s==2)if(tn==0&&J.from==null){let le=J.range(n,null,null,N);J.min=le[0],J.max=le[1]}else J.min=zt,J.max=-zt}}if(tn>0){y.forEach((N,G)=>{if(s==1){let J=N.scale,le=H[J];if(le==null)return;let pe=_[J];if(G==0){let be=pe.range(n,pe.min,pe.max,J);pe.min=be[0],pe.max=be[1],on=es(pe.min,e[0]),an=es(pe.max,e[0]),an-on>1&&(e[0][on]<pe.min&&on++,e[0][an]>pe.max&&an--),N.min=gi[on],N.max=gi[an]}else N.show&&N.auto&&Ve(pe,le,N,e[G],N.sorted);N.idxs[0]=on,N.idxs[1]=an}else if(G>0&&N.show&&N.auto){let[J,le]=N.facets,pe=J.scale,be=le.scale,[Ue,Fe]=e[G],Be=_[pe],ot=_[be];Be!=null&&Ve(Be,H[pe],J,Ue,J.sorted),ot!=null&&Ve(ot,H[be],le,Fe,le.sorted),N.min=le.min,N.max=le.max}});for(let N in _){let G=_[N],J=H[N];if(G.from==null&&(J==null||J.min==null)){let le=G.range(n,G.min==zt?null:G.min,G.max==-zt?null:G.max,N);G.min=le[0],G.max=le[1]}}}for(let N in _){let G=_[N];if(G.from!=null){let J=_[G.from];if(J.min==null)G.min=G.max=null;else{let le=G.range(n,J.min,J.max,N);G.min=le[0],G.max=le[1]}}}let w={},I=!1;for(let N in _){let G=_[N],J=b[N];if(J.min!=G.min||J.max!=G.max){J.min=G.min,J.max=G.max;let le=J.distr;J._min=le==3?js(J.min):le==4?Up(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?js(J.max):le==4?Up(J.max,J.asinh):le==100?J.fwd(J.max):J.max,w[N]=I=!0}}if(I){y.forEach((N,G)=>{s==2?G>0&&w.y&&(N._paths=null):w[N.scale]&&(N._paths=null)});for(let N in w)ye=!0,Nn("setScale",N);ge&&de.left>=0&&(ne=me=!0)}for(let N in H)H[N]=null}function He(_){let w=Wp(on-1,0,tn-1),I=Wp(an+1,0,tn-1);for(;_[w]==null&&w>0;)w--;for(;_[I]==null&&I<tn-1;)I++;return[w,I]}function vt(){if(tn>0){let _=y.some(w=>w._focus)&&Le!=ze.alpha;_&&(u.globalAlpha=Le=ze.alpha),y.forEach((w,I)=>{if(I>0&&w.show&&(Jt(I,!1),Jt(I,!0),w._paths==null)){let N=Le;Le!=w.alpha&&(u.globalAlpha=Le=w.alpha);let G=s==2?[0,e[I][0].length-1]:He(e[I]);w._paths=w.paths(n,I,G[0],G[1]),Le!=N&&(u.globalAlpha=Le=N)}}),y.forEach((w,I)=>{if(I>0&&w.show){let N=Le;Le!=w.alpha&&(u.globalAlpha=Le=w.alpha),w._paths!=null&&It(I,!1);{let G=w._paths!=null?w._paths.gaps:null,J=w.points.show(n,I,on,an,G),le=w.points.filter(n,I,J,G);(J||le)&&(w.points._paths=w.points.paths(n,I,on,an,le),It(I,!0))}Le!=N&&(u.globalAlpha=Le=N),Nn("drawSeries",I)}}),_&&(u.globalAlpha=Le=1)}}function Jt(_,w){let I=w?y[_].points:y[_];I._stroke=I.stroke(n,_),I._fill=I.fill(n,_)}function It(_,w){let I=w?y[_].points:y[_],{stroke:N,fill:G,clip:J,flags:le,_stroke:pe=I._stroke,_fill:be=I._fill,_width:Ue=I.width}=I._paths;Ue=Ht(Ue*Rt,3);let Fe=null,Be=Ue%2/2;w&&be==null&&(be=Ue>0?"#fff":pe);let ot=I.pxAlign==1&&Be>0;if(ot&&u.translate(Be,Be),!w){let Et=P-Ue/2,wt=S-Ue/2,yt=$+Ue,Qe=ue+Ue;Fe=new Path2D,Fe.rect(Et,wt,yt,Qe)}w?ke(pe,Ue,I.dash,I.cap,be,N,G,le,J):Lt(_,pe,Ue,I.dash,I.cap,be,N,G,le,Fe,J),ot&&u.translate(-Be,-Be)}function Lt(_,w,I,N,G,J,le,pe,be,Ue,Fe){let Be=!1;be!=0&&C.forEach((ot,Et)=>{if(ot.series[0]==_){let wt=y[ot.series[1]],yt=e[ot.series[1]],Qe=(wt._paths||Fl).band;Sr(Qe)&&(Qe=ot.dir==1?Qe[0]:Qe[1]);let Ye,qt=null;wt.show&&Qe&&ZE(yt,on,an)?(qt=ot.fill(n,Et)||J,Ye=wt._paths.clip):Qe=null,ke(w,I,N,G,qt,le,pe,be,Ue,Fe,Ye,Qe),Be=!0}}),Be||ke(w,I,N,G,J,le,pe,be,Ue,Fe)}let vn=xa|$p;function ke(_,w,I,N,G,J,le,pe,be,Ue,Fe,Be){Ae(_,w,I,N,G),(be||Ue||Be)&&(u.save(),be&&u.clip(be),Ue&&u.clip(Ue)),Be?(pe&vn)==vn?(u.clip(Be),Fe&&u.clip(Fe),bt(G,le),dn(_,J,w)):pe&$p?(bt(G,le),u.clip(Be),dn(_,J,w)):pe&xa&&(u.save(),u.clip(Be),Fe&&u.clip(Fe),bt(G,le),u.restore(),dn(_,J,w)):(bt(G,le),dn(_,J,w)),(be||Ue||Be)&&u.restore()}function dn(_,w,I){I>0&&(w instanceof Map?w.forEach((N,G)=>{u.strokeStyle=co=G,u.stroke(N)}):w!=null&&_&&u.stroke(w))}function bt(_,w){w instanceof Map?w.forEach((I,N)=>{u.fillStyle=tr=N,u.fill(I)}):w!=null&&_&&u.fill(w)}function As(_,w,I,N){let G=M[_],J;if(N<=0)J=[0,0];else{let le=G._space=G.space(n,_,w,I,N),pe=G._incrs=G.incrs(n,_,w,I,N,le);J=_A(w,I,pe,N,le)}return G._found=J}function fn(_,w,I,N,G,J,le,pe,be,Ue){let Fe=le%2/2;v==1&&u.translate(Fe,Fe),Ae(pe,le,be,Ue,pe),u.beginPath();let Be,ot,Et,wt,yt=G+(N==0||N==3?-J:J);I==0?(ot=G,wt=yt):(Be=G,Et=yt);for(let Qe=0;Qe<_.length;Qe++)w[Qe]!=null&&(I==0?Be=Et=_[Qe]:ot=wt=_[Qe],u.moveTo(Be,ot),u.lineTo(Et,wt));u.stroke(),v==1&&u.translate(-Fe,-Fe)}function uo(_){let w=!0;return M.forEach((I,N)=>{if(!I.show)return;let G=b[I.scale];if(G.min==null){I._show&&(w=!1,I._show=!1,dt(!1));return}else I._show||(w=!1,I._show=!0,dt(!1));let J=I.side,le=J%2,{min:pe,max:be}=G,[Ue,Fe]=As(N,pe,be,le==0?F:Ie);if(Fe==0)return;let Be=G.distr==2,ot=I._splits=I.splits(n,N,pe,be,Ue,Fe,Be),Et=G.distr==2?ot.map(Ye=>gi[Ye]):ot,wt=G.distr==2?gi[ot[1]]-gi[ot[0]]:Ue,yt=I._values=I.values(n,I.filter(n,Et,N,Fe,wt),N,Fe,wt);I._rotate=J==2?I.rotate(n,yt,N,Fe):0;let Qe=I._size;I._size=Hi(I.size(n,yt,N,_)),Qe!=null&&I._size!=Qe&&(w=!1)}),w}function os(_){let w=!0;return Aa.forEach((I,N)=>{let G=I(n,N,ss,_);G!=Gi[N]&&(w=!1),Gi[N]=G}),w}function Rs(){for(let _=0;_<M.length;_++){let w=M[_];if(!w.show||!w._show)continue;let I=w.side,N=I%2,G,J,le=w.stroke(n,_),pe=I==0||I==3?-1:1,[be,Ue]=w._found;if(w.label!=null){let Qn=w.labelGap*pe,vi=En((w._lpos+Qn)*Rt);De(w.labelFont[0],le,"center",I==2?"top":Px),u.save(),N==1?(G=J=0,u.translate(vi,En(S+ue/2)),u.rotate((I==3?-fu:fu)/2)):(G=En(P+$/2),J=vi);let Dr=v_(w.label)?w.label(n,_,be,Ue):w.label;u.fillText(Dr,G,J),u.restore()}if(Ue==0)continue;let Fe=b[w.scale],Be=N==0?$:ue,ot=N==0?P:S,Et=w._splits,wt=Fe.distr==2?Et.map(Qn=>gi[Qn]):Et,yt=Fe.distr==2?gi[Et[1]]-gi[Et[0]]:be,Qe=w.ticks,Ye=w.border,qt=Qe.show?Qe.size:0,sn=En(qt*Rt),Dn=En((w.alignTo==2?w._size-qt-w.gap:w.gap)*Rt),Ut=w._rotate*-fu/180,rn=g(w._pos*Rt),xi=(sn+Dn)*pe,Jn=rn+xi;J=N==0?Jn:0,G=N==1?Jn:0;let Li=w.font[0],Wi=w.align==1?ua:w.align==2?Np:Ut>0?ua:Ut<0?Np:N==0?"center":I==3?Np:ua,cs=Ut||N==1?"middle":I==2?"top":Px;De(Li,le,Wi,cs);let _i=w.font[1]*w.lineGap,Ni=Et.map(Qn=>g(a(Qn,Fe,Be,ot))),Xi=w._values;for(let Qn=0;Qn<Xi.length;Qn++){let vi=Xi[Qn];if(vi!=null){N==0?G=Ni[Qn]:J=Ni[Qn],vi=""+vi;let Dr=vi.indexOf(`
`)==-1?[vi]:vi.split(/\n/gm);for(let ei=0;ei<Dr.length;ei++){let tg=Dr[ei];Ut?(u.save(),u.translate(G,J+ei*_i),u.rotate(Ut),u.fillText(tg,0,0),u.restore()):u.fillText(tg,G,J+ei*_i)}}}Qe.show&&fn(Ni,Qe.filter(n,wt,_,Ue,yt),N,I,rn,sn,Ht(Qe.width*Rt,3),Qe.stroke(n,_),Qe.dash,Qe.cap);let hs=w.grid;hs.show&&fn(Ni,hs.filter(n,wt,_,Ue,yt),N,N==0?2:1,N==0?S:P,N==0?ue:$,Ht(hs.width*Rt,3),hs.stroke(n,_),hs.dash,hs.cap),Ye.show&&fn([rn],[1],N==0?1:0,N==0?1:2,N==1?S:P,N==1?ue:$,Ht(Ye.width*Rt,3),Ye.stroke(n,_),Ye.dash,Ye.cap)}Nn("drawAxes")}function dt(_){y.forEach((w,I)=>{I>0&&(w._paths=null,_&&(s==1?(w.min=null,w.max=null):w.facets.forEach(N=>{N.min=null,N.max=null})))})}let nn=!1,Zn=!1,Nt=[];function pn(){Zn=!1;for(let _=0;_<Nt.length;_++)Nn(...Nt[_]);Nt.length=0}function Xn(){nn||(u1(Fm),nn=!0)}function tc(_,w=!1){nn=!0,Zn=w,_(n),Fm(),w&&Nt.length>0&&queueMicrotask(pn)}n.batch=tc;function Fm(){if(ae&&(_t(),ae=!1),ye&&(Te(),ye=!1),_e){if($t(f,ua,Je),$t(f,"top",lt),$t(f,Nl,F),$t(f,Dl,Ie),$t(p,ua,Je),$t(p,"top",lt),$t(p,Nl,F),$t(p,Dl,Ie),$t(d,Nl,en),$t(d,Dl,un),h.width=En(en*Rt),h.height=En(un*Rt),M.forEach(({_el:_,_show:w,_size:I,_pos:N,side:G})=>{if(_!=null)if(w){let J=G===3||G===0?I:0,le=G%2==1;$t(_,le?"left":"top",N-J),$t(_,le?"width":"height",I),$t(_,le?"top":"left",le?lt:Je),$t(_,le?"height":"width",le?Ie:F),Vp(_,io)}else Ei(_,io)}),co=tr=ho=z=Q=K=j=Ee=T=null,Le=1,La(!0),Je!=we||lt!=kt||F!=Ge||Ie!=Ze){dt(!1);let _=F/Ge,w=Ie/Ze;if(ge&&!ne&&de.left>=0){de.left*=_,de.top*=w,fo&&Ms(fo,En(de.left),0,F,Ie),po&&Ms(po,0,En(de.top),F,Ie);for(let I=0;I<ht.length;I++){let N=ht[I];N!=null&&(Gt[I]*=_,jn[I]*=w,Ms(N,Hi(Gt[I]),Hi(jn[I]),F,Ie))}}if(Xt.show&&!re&&Xt.left>=0&&Xt.width>0){Xt.left*=_,Xt.width*=_,Xt.top*=w,Xt.height*=w;for(let I in fd)$t(xo,I,Xt[I])}we=Je,kt=lt,Ge=F,Ze=Ie}Nn("setSize"),_e=!1}en>0&&un>0&&(u.clearRect(0,0,h.width,h.height),Nn("drawClear"),E.forEach(_=>_()),Nn("draw")),Xt.show&&re&&(nc(Xt),re=!1),ge&&ne&&(Nr(null,!0,!1),ne=!1),fe.show&&fe.live&&me&&(ud(),me=!1),c||(c=!0,n.status=1,Nn("ready")),er=!1,nn=!1}n.redraw=(_,w)=>{ye=w||!1,_!==!1?ir(A,L.min,L.max):Xn()};function ld(_,w){let I=b[_];if(I.from==null){if(tn==0){let N=I.range(n,w.min,w.max,_);w.min=N[0],w.max=N[1]}if(w.min>w.max){let N=w.min;w.min=w.max,w.max=N}if(tn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;_==A&&I.distr==2&&tn>0&&(w.min=es(w.min,e[0]),w.max=es(w.max,e[0]),w.min==w.max&&w.max++),H[_]=w,ae=!0,Xn()}}n.setScale=ld;let cd,hd,fo,po,km,Bm,mo,go,zm,Hm,Wt,Kt,nr=!1,Bn=de.drag,In=Bn.x,Ln=Bn.y;ge&&(de.x&&(cd=zi(OE,p)),de.y&&(hd=zi(UE,p)),L.ori==0?(fo=cd,po=hd):(fo=hd,po=cd),Wt=de.left,Kt=de.top);let Xt=n.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),xo=Xt.show?zi(DE,Xt.over?p:f):null;function nc(_,w){if(Xt.show){for(let I in _)Xt[I]=_[I],I in fd&&$t(xo,I,_[I]);w!==!1&&Nn("setSelect")}}n.setSelect=nc;function ey(_){if(y[_].show)te&&Vp(at[_],io);else if(te&&Ei(at[_],io),ge){let I=Pe?ht[0]:ht[_];I!=null&&Ms(I,-10,-10,F,Ie)}}function ir(_,w,I){ld(_,{min:w,max:I})}function as(_,w,I,N){w.focus!=null&&ry(_),w.show!=null&&y.forEach((G,J)=>{J>0&&(_==J||_==null)&&(G.show=w.show,ey(J),s==2?(ir(G.facets[0].scale,null,null),ir(G.facets[1].scale,null,null)):ir(G.scale,null,null),Xn())}),I!==!1&&Nn("setSeries",_,w),N&&Na("setSeries",n,_,w)}n.setSeries=as;function ty(_,w){xn(C[_],w)}function ny(_,w){_.fill=St(_.fill||null),_.dir=Tt(_.dir,-1),w=w??C.length,C.splice(w,0,_)}function iy(_){_==null?C.length=0:C.splice(_,1)}n.addBand=ny,n.setBand=ty,n.delBand=iy;function sy(_,w){y[_].alpha=w,ge&&ht[_]!=null&&(ht[_].style.opacity=w),te&&at[_]&&(at[_].style.opacity=w)}let Cs,sr,Lr,_o={focus:!0};function ry(_){if(_!=Lr){let w=_==null,I=ze.alpha!=1;y.forEach((N,G)=>{if(s==1||G>0){let J=w||G==0||G==_;N._focus=w?null:J,I&&sy(G,J?1:ze.alpha)}}),Lr=_,I&&Xn()}}te&&tt&&Mt(Dx,Ce,_=>{de._lock||(et(_),Lr!=null&&as(null,_o,!0,mn.setSeries))});function ls(_,w,I){let N=b[w];I&&(_=_/Rt-(N.ori==1?lt:Je));let G=F;N.ori==1&&(G=Ie,_=G-_),N.dir==-1&&(_=G-_);let J=N._min,le=N._max,pe=_/G,be=J+(le-J)*pe,Ue=N.distr;return Ue==3?pa(10,be):Ue==4?QE(be,N.asinh):Ue==100?N.bwd(be):be}function oy(_,w){let I=ls(_,A,w);return es(I,e[0],on,an)}n.valToIdx=_=>es(_,e[0]),n.posToIdx=oy,n.posToVal=ls,n.valToPos=(_,w,I)=>b[w].ori==0?r(_,b[w],I?$:F,I?P:0):o(_,b[w],I?ue:Ie,I?S:0),n.setCursor=(_,w,I)=>{Wt=_.left,Kt=_.top,Nr(null,w,I)};function Vm(_,w){$t(xo,ua,Xt.left=_),$t(xo,Nl,Xt.width=w)}function Gm(_,w){$t(xo,"top",Xt.top=_),$t(xo,Dl,Xt.height=w)}let Pa=L.ori==0?Vm:Gm,Ia=L.ori==1?Vm:Gm;function ay(){if(te&&fe.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&ut)continue;let w=fe.values[_],I=0;for(let N in w)We[_][I++].firstChild.nodeValue=w[N]}}function ud(_,w){if(_!=null&&(_.idxs?_.idxs.forEach((I,N)=>{se[N]=I}):i1(_.idx)||se.fill(_.idx),fe.idx=se[0]),te&&fe.live){for(let I=0;I<y.length;I++)(I>0||s==1&&!ut)&&ly(I,se[I]);ay()}me=!1,w!==!1&&Nn("setLegend")}n.setLegend=ud;function ly(_,w){let I=y[_],N=_==0&&W==2?gi:e[_],G;ut?G=I.values(n,_,w)??rt:(G=I.value(n,w==null?null:N[w],_,w),G=G==null?rt:{_:G}),fe.values[_]=G}function Nr(_,w,I){zm=Wt,Hm=Kt,[Wt,Kt]=de.move(n,Wt,Kt),de.left=Wt,de.top=Kt,ge&&(fo&&Ms(fo,En(Wt),0,F,Ie),po&&Ms(po,0,En(Kt),F,Ie));let N,G=on>an;Cs=zt,sr=null;let J=L.ori==0?F:Ie,le=L.ori==1?F:Ie;if(Wt<0||tn==0||G){N=de.idx=null;for(let pe=0;pe<y.length;pe++){let be=ht[pe];be!=null&&Ms(be,-10,-10,F,Ie)}tt&&as(null,_o,!0,_==null&&mn.setSeries),fe.live&&(se.fill(N),me=!0)}else{let pe,be,Ue;s==1&&(pe=L.ori==0?Wt:Kt,be=ls(pe,A),N=de.idx=es(be,e[0],on,an),Ue=X(e[0][N],L,J,0));let Fe=-10,Be=-10,ot=0,Et=0,wt=!0,yt="",Qe="";for(let Ye=s==2?1:0;Ye<y.length;Ye++){let qt=y[Ye],sn=se[Ye],Dn=sn==null?null:s==1?e[Ye][sn]:e[Ye][1][sn],Ut=de.dataIdx(n,Ye,N,be),rn=Ut==null?null:s==1?e[Ye][Ut]:e[Ye][1][Ut];if(me=me||rn!=Dn||Ut!=sn,se[Ye]=Ut,Ye>0&&qt.show){let xi=Ut==null?-10:Ut==N?Ue:X(s==1?e[0][Ut]:e[Ye][0][Ut],L,J,0),Jn=rn==null?-10:O(rn,s==1?b[qt.scale]:b[qt.facets[1].scale],le,0);if(tt&&rn!=null){let Li=L.ori==1?Wt:Kt,Wi=An(ze.dist(n,Ye,Ut,Jn,Li));if(Wi<Cs){let cs=ze.bias;if(cs!=0){let _i=ls(Li,qt.scale),Ni=rn>=0?1:-1,Xi=_i>=0?1:-1;Xi==Ni&&(Xi==1?cs==1?rn>=_i:rn<=_i:cs==1?rn<=_i:rn>=_i)&&(Cs=Wi,sr=Ye)}else Cs=Wi,sr=Ye}}if(me||Pe){let Li,Wi;L.ori==0?(Li=xi,Wi=Jn):(Li=Jn,Wi=xi);let cs,_i,Ni,Xi,hs,Qn,vi=!0,Dr=he.bbox;if(Dr!=null){vi=!1;let ei=Dr(n,Ye);Ni=ei.left,Xi=ei.top,cs=ei.width,_i=ei.height}else Ni=Li,Xi=Wi,cs=_i=he.size(n,Ye);if(Qn=he.fill(n,Ye),hs=he.stroke(n,Ye),Pe)Ye==sr&&Cs<=ze.prox&&(Fe=Ni,Be=Xi,ot=cs,Et=_i,wt=vi,yt=Qn,Qe=hs);else{let ei=ht[Ye];ei!=null&&(Gt[Ye]=Ni,jn[Ye]=Xi,Hx(ei,cs,_i,vi),Bx(ei,Qn,hs),Ms(ei,Hi(Ni),Hi(Xi),F,Ie))}}}}if(Pe){let Ye=ze.prox,qt=Lr==null?Cs<=Ye:Cs>Ye||sr!=Lr;if(me||qt){let sn=ht[0];sn!=null&&(Gt[0]=Fe,jn[0]=Be,Hx(sn,ot,Et,wt),Bx(sn,yt,Qe),Ms(sn,Hi(Fe),Hi(Be),F,Ie))}}}if(Xt.show&&nr)if(_!=null){let[pe,be]=mn.scales,[Ue,Fe]=mn.match,[Be,ot]=_.cursor.sync.scales,Et=_.cursor.drag;if(In=Et._x,Ln=Et._y,In||Ln){let{left:wt,top:yt,width:Qe,height:Ye}=_.select,qt=_.scales[Be].ori,sn=_.posToVal,Dn,Ut,rn,xi,Jn,Li=pe!=null&&Ue(pe,Be),Wi=be!=null&&Fe(be,ot);Li&&In?(qt==0?(Dn=wt,Ut=Qe):(Dn=yt,Ut=Ye),rn=b[pe],xi=X(sn(Dn,Be),rn,J,0),Jn=X(sn(Dn+Ut,Be),rn,J,0),Pa(ts(xi,Jn),An(Jn-xi))):Pa(0,J),Wi&&Ln?(qt==1?(Dn=wt,Ut=Qe):(Dn=yt,Ut=Ye),rn=b[be],xi=O(sn(Dn,ot),rn,le,0),Jn=O(sn(Dn+Ut,ot),rn,le,0),Ia(ts(xi,Jn),An(Jn-xi))):Ia(0,le)}else pd()}else{let pe=An(zm-km),be=An(Hm-Bm);if(L.ori==1){let ot=pe;pe=be,be=ot}In=Bn.x&&pe>=Bn.dist,Ln=Bn.y&&be>=Bn.dist;let Ue=Bn.uni;Ue!=null?In&&Ln&&(In=pe>=Ue,Ln=be>=Ue,!In&&!Ln&&(be>pe?Ln=!0:In=!0)):Bn.x&&Bn.y&&(In||Ln)&&(In=Ln=!0);let Fe,Be;In&&(L.ori==0?(Fe=mo,Be=Wt):(Fe=go,Be=Kt),Pa(ts(Fe,Be),An(Be-Fe)),Ln||Ia(0,le)),Ln&&(L.ori==1?(Fe=mo,Be=Wt):(Fe=go,Be=Kt),Ia(ts(Fe,Be),An(Be-Fe)),In||Pa(0,J)),!In&&!Ln&&(Pa(0,0),Ia(0,0))}if(Bn._x=In,Bn._y=Ln,_==null){if(I){if(eg!=null){let[pe,be]=mn.scales;mn.values[0]=pe!=null?ls(L.ori==0?Wt:Kt,pe):null,mn.values[1]=be!=null?ls(L.ori==1?Wt:Kt,be):null}Na(Dp,n,Wt,Kt,F,Ie,N)}if(tt){let pe=I&&mn.setSeries,be=ze.prox;Lr==null?Cs<=be&&as(sr,_o,!0,pe):Cs>be?as(null,_o,!0,pe):sr!=Lr&&as(sr,_o,!0,pe)}}me&&(fe.idx=N,ud()),w!==!1&&Nn("setCursor")}let rr=null;Object.defineProperty(n,"rect",{get(){return rr==null&&La(!1),rr}});function La(_=!1){_?rr=null:(rr=p.getBoundingClientRect(),Nn("syncRect",rr))}function Wm(_,w,I,N,G,J,le){de._lock||nr&&_!=null&&_.movementX==0&&_.movementY==0||(dd(_,w,I,N,G,J,le,!1,_!=null),_!=null?Nr(null,!0,!0):Nr(w,!0,!1))}function dd(_,w,I,N,G,J,le,pe,be){if(rr==null&&La(!1),et(_),_!=null)I=_.clientX-rr.left,N=_.clientY-rr.top;else{if(I<0||N<0){Wt=-10,Kt=-10;return}let[Ue,Fe]=mn.scales,Be=w.cursor.sync,[ot,Et]=Be.values,[wt,yt]=Be.scales,[Qe,Ye]=mn.match,qt=w.axes[0].side%2==1,sn=L.ori==0?F:Ie,Dn=L.ori==1?F:Ie,Ut=qt?J:G,rn=qt?G:J,xi=qt?N:I,Jn=qt?I:N;if(wt!=null?I=Qe(Ue,wt)?a(ot,b[Ue],sn,0):-10:I=sn*(xi/Ut),yt!=null?N=Ye(Fe,yt)?a(Et,b[Fe],Dn,0):-10:N=Dn*(Jn/rn),L.ori==1){let Li=I;I=N,N=Li}}be&&(w==null||w.cursor.event.type==Dp)&&((I<=1||I>=F-1)&&(I=to(I,F)),(N<=1||N>=Ie-1)&&(N=to(N,Ie))),pe?(km=I,Bm=N,[mo,go]=de.move(n,I,N)):(Wt=I,Kt=N)}let fd={width:0,height:0,left:0,top:0};function pd(){nc(fd,!1)}let Xm,qm,$m,Ym;function Km(_,w,I,N,G,J,le){nr=!0,In=Ln=Bn._x=Bn._y=!1,dd(_,w,I,N,G,J,le,!0,!1),_!=null&&(Mt(Op,zp,jm,!1),Na(Lx,n,mo,go,F,Ie,null));let{left:pe,top:be,width:Ue,height:Fe}=Xt;Xm=pe,qm=be,$m=Ue,Ym=Fe}function jm(_,w,I,N,G,J,le){nr=Bn._x=Bn._y=!1,dd(_,w,I,N,G,J,le,!1,!0);let{left:pe,top:be,width:Ue,height:Fe}=Xt,Be=Ue>0||Fe>0,ot=Xm!=pe||qm!=be||$m!=Ue||Ym!=Fe;if(Be&&ot&&nc(Xt),Bn.setScale&&Be&&ot){let Et=pe,wt=Ue,yt=be,Qe=Fe;if(L.ori==1&&(Et=be,wt=Fe,yt=pe,Qe=Ue),In&&ir(A,ls(Et,A),ls(Et+wt,A)),Ln)for(let Ye in b){let qt=b[Ye];Ye!=A&&qt.from==null&&qt.min!=zt&&ir(Ye,ls(yt+Qe,Ye),ls(yt,Ye))}pd()}else de.lock&&(de._lock=!de._lock,Nr(w,!0,_!=null));_!=null&&(_n(Op,zp),Na(Op,n,Wt,Kt,F,Ie,null))}function cy(_,w,I,N,G,J,le){if(de._lock)return;et(_);let pe=nr;if(nr){let be=!0,Ue=!0,Fe=10,Be,ot;L.ori==0?(Be=In,ot=Ln):(Be=Ln,ot=In),Be&&ot&&(be=Wt<=Fe||Wt>=F-Fe,Ue=Kt<=Fe||Kt>=Ie-Fe),Be&&be&&(Wt=Wt<mo?0:F),ot&&Ue&&(Kt=Kt<go?0:Ie),Nr(null,!0,!0),nr=!1}Wt=-10,Kt=-10,se.fill(null),Nr(null,!0,!0),pe&&(nr=pe)}function Zm(_,w,I,N,G,J,le){de._lock||(et(_),Ca(),pd(),_!=null&&Na(Ox,n,Wt,Kt,F,Ie,null))}function Jm(){M.forEach(vA),U(n.width,n.height,!0)}so(pu,fa,Jm);let vo={};vo.mousedown=Km,vo.mousemove=Wm,vo.mouseup=jm,vo.dblclick=Zm,vo.setSeries=(_,w,I,N)=>{let G=mn.match[2];I=G(n,w,I),I!=-1&&as(I,N,!0,!1)},ge&&(Mt(Lx,p,Km),Mt(Dp,p,Wm),Mt(Nx,p,_=>{et(_),La(!1)}),Mt(Dx,p,cy),Mt(Ox,p,Zm),Yp.add(n),n.syncRect=La);let ic=n.hooks=i.hooks||{};function Nn(_,w,I){Zn?Nt.push([_,w,I]):_ in ic&&ic[_].forEach(N=>{N.call(null,n,w,I)})}(i.plugins||[]).forEach(_=>{for(let w in _.hooks)ic[w]=(ic[w]||[]).concat(_.hooks[w])});let Qm=(_,w,I)=>I,mn=xn({key:null,setSeries:!1,filters:{pub:qx,sub:qx},scales:[A,y[1]?y[1].scale:null],match:[$x,$x,Qm],values:[null,null]},de.sync);mn.match.length==2&&mn.match.push(Qm),de.sync=mn;let eg=mn.key,md=G_(eg);function Na(_,w,I,N,G,J,le){mn.filters.pub(_,w,I,N,G,J,le)&&md.pub(_,w,I,N,G,J,le)}md.sub(n);function hy(_,w,I,N,G,J,le){mn.filters.sub(_,w,I,N,G,J,le)&&vo[_](null,w,I,N,G,J,le)}n.pub=hy;function uy(){md.unsub(n),Yp.delete(n),Pn.clear(),Gp(pu,fa,Jm),l.remove(),Ce?.remove(),Nn("destroy")}n.destroy=uy;function gd(){Nn("init",i,e),Ra(e||i.data,!1),H[A]?ld(A,H[A]):Ca(),re=Xt.show&&(Xt.width>0||Xt.height>0),ne=me=!0,U(i.width,i.height)}return y.forEach(lo),M.forEach(Ts),t?t instanceof HTMLElement?(t.appendChild(l),gd()):t(n,gd):gd(),n}Gn.assign=xn;Gn.fmtNum=tm;Gn.rangeNum=mu;Gn.rangeLog=_u;Gn.rangeAsinh=Qp;Gn.orient=oo;Gn.pxRatio=Rt;Gn.join=h1;Gn.fmtDate=im,Gn.tzDate=b1;Gn.sync=G_;{Gn.addGap=iA,Gn.clipGaps=bu;let i=Gn.paths={points:K_};i.linear=Z_,i.stepped=oA,i.bars=aA,i.spline=cA}var yA=11;function tv(i,e,t,n){let s=i.ctx,{left:r,width:o}=i.bbox,a=yA*devicePixelRatio,c=[],l=e.map((u,d)=>d),h=u=>n.includes(e[u])?0:u===0||u===e.length-1?1:2;l.sort((u,d)=>h(u)-h(d)||u-d),s.save(),s.font=`${10*devicePixelRatio}px system-ui`,s.textBaseline="middle",s.textAlign="left";for(let u of l){let d=i.valToPos(t(u),"y",!0);c.some(f=>Math.abs(f-d)<a)||(c.push(d),s.fillStyle=Re(h(u)===0?"--accent":"--ink-soft"),s.fillText(String(e[u]),r+o+4*devicePixelRatio,d))}s.restore()}function Eu(i){let e=new DataView(i).getUint32(0,!0);return{...JSON.parse(new TextDecoder().decode(new Uint8Array(i,4,e))),values:new Float32Array(i,4+e)}}function hm(i,e){return`${i} ${e.includes("/")?"of":"at"} ${e}`}var bA=24,SA=150,MA=20,wA=22,Tu=class{constructor(e,t,n,s,r){this.place=e;this.titles=t;this.colourOf=n;this.choose=s;this.hover=r;R("axis").addEventListener("change",()=>this.restyle()),new ResizeObserver(()=>this.fit()).observe(e)}place;titles;colourOf;choose;hover;now=null;pinned=null;plots=[];sheets=[];lit=null;pointed=null;other=null;low=0;high=1;key="";get revision(){return this.now?.revision??-1}take(e){e.stage==="pinned"?this.pinned=e:this.now=e,this.now&&this.draw()}outdate(){this.now&&(this.now.revision=-1),this.pinned=null}unpin(){this.pinned=null,this.now&&this.draw()}light(e,t=null){[this.lit,this.other]=[e,t],this.repaint()}point(e){e!==this.pointed&&(this.pointed=e,this.repaint())}repaint(){for(let e of this.plots)e.redraw(!1)}restyle(){this.key="",this.now&&this.draw()}draw(){let e=this.now;R("validity-chip").hidden=!1,R("validity-words").textContent=e.validity,this.range();let t=[e.quantity,e.unit,...e.heard_by].join("|");t!==this.key&&this.build(t);for(let n of this.plots)n.setData([e.frequency,e.frequency.map(()=>null)],!0);document.documentElement.dataset.painted=String(e.revision)}range(){let e=1/0,t=-1/0;for(let s of[this.now,this.comparable()])for(let r of s?.values??[])r<e&&(e=r),r>t&&(t=r);let n=Math.max((t-e)*.05,.1);[this.low,this.high]=[e-n,t+n]}comparable(){return this.pinned&&this.pinned.quantity===this.now?.quantity?this.pinned:null}build(e){this.key=e;for(let s of this.plots)s.destroy();this.place.replaceChildren();let t=this.now,n=this.titles()[t.quantity]??t.quantity;this.plots=t.heard_by.map((s,r)=>{let o=q("figure",{class:"plot"},q("figcaption",{},hm(n,s)));this.place.append(o);let a={stroke:Re("--ink-soft"),grid:{stroke:Re("--grid"),width:1},ticks:{stroke:Re("--grid")},font:"12px system-ui",labelFont:"12px system-ui",labelSize:20},c=new Gn({width:this.width(),height:this.height(),padding:[null,wA,null,null],legend:{show:!1},cursor:{y:!1,points:{show:!1},drag:{x:!1,y:!1}},scales:{x:{time:!1,distr:R("axis").value==="linear"?1:3},y:{range:()=>[this.low,this.high]}},axes:[{...a,label:"frequency (Hz)",size:34,filter:(l,h)=>h,values:(l,h)=>h.map(u=>R("axis").value==="linear"||/^[125]/.test(String(u))?String(u):"")},{...a,label:`${n.split(",")[0]} (${t.unit})`,size:54}],series:[{},{paths:()=>null,points:{show:!1}}],hooks:{draw:[l=>this.paint(l,r)],setCursor:[l=>this.read(l,r)]}},[t.frequency,t.frequency.map(()=>null)],o);return c.over.addEventListener("click",l=>this.choose(this.near(c,r)?.point??null,l.shiftKey)),c.over.addEventListener("mouseleave",()=>{R("pointed-curve").textContent="\xA0",this.hover(null)}),c.ctx.canvas.setAttribute("role","img"),c.ctx.canvas.setAttribute("aria-label",`${hm(n,s)} over frequency, a curve for each of ${t.points.length} points; CSV has the values`),c})}across(){let e=this.place.clientWidth,t=this.now?.heard_by.length??1;return t===1?1:e>1100&&t>2?3:e>560?2:1}width(){let e=this.place.clientWidth,t=this.across();return Math.max(Math.floor((e-12*(t-1))/t),220)}height(){let e=Math.ceil((this.now?.heard_by.length??1)/this.across());return Math.max(Math.floor(this.place.clientHeight/Math.min(e,2))-MA-4,SA)}fit(){let e=this.width(),t=this.height();for(let n of this.plots)(n.width!==e||n.height!==t)&&n.setSize({width:e,height:t})}paint(e,t){let{left:n,top:s,width:r,height:o}=e.bbox,a=this.sheets[t]??=q("canvas");a.width=r,a.height=o;let c=a.getContext("2d",{willReadFrequently:!0});c.translate(-n,-s),c.lineJoin="round";for(let u of[this.comparable(),this.now]){if(!u||t>=u.heard_by.length)continue;c.setLineDash(u===this.now?[]:[5*devicePixelRatio,4*devicePixelRatio]);let d=u.frequency.map(g=>e.valToPos(g,"x",!0)),f=e.valToPos(0,"y",!0),p=e.valToPos(1,"y",!0)-f,v=g=>{let m=(g*u.heard_by.length+t)*d.length;c.beginPath();for(let y=0;y<d.length;y++)c.lineTo(d[y],f+p*u.values[m+y]);c.stroke()};u.points.forEach((g,m)=>{g===this.lit||g===this.pointed||g===this.other||(c.globalAlpha=this.lit===null?u===this.now?1:.6:.22,c.lineWidth=1.4*devicePixelRatio,c.strokeStyle=this.colourOf(g),v(m))});for(let[g,m]of[[this.other,"--ink"],[this.pointed,""],[this.lit,"--accent"]]){let y=g===null?-1:u.points.indexOf(g);y<0||(c.globalAlpha=1,c.lineWidth=3*devicePixelRatio,c.strokeStyle=m?Re(m):this.colourOf(g),v(y))}}e.ctx.drawImage(a,n,s);let l=this.now,h=l.frequency.length;tv(e,l.points,u=>l.values[(u*l.heard_by.length+t)*h+h-1],[this.lit,this.pointed,this.other])}near(e,t){let n=this.now,{left:s,top:r}=e.cursor;if(!n||s===void 0||r===void 0||s<0)return null;let o=e.posToVal(s,"x"),a=0;for(let h=0;h<n.frequency.length;h++)Math.abs(Math.log(n.frequency[h]/o))<Math.abs(Math.log(n.frequency[a]/o))&&(a=h);let c=null,l=bA;return n.points.forEach((h,u)=>{let d=n.values[(u*n.heard_by.length+t)*n.frequency.length+a],f=Math.abs(e.valToPos(d,"y")-r);f<l&&(l=f,c={point:h,at:a,value:d})}),c}read(e,t){let n=this.near(e,t),s=this.now;if(!n||!s)return;this.hover(n.point);let r=a=>s.values[(s.points.indexOf(a)*s.heard_by.length+t)*s.frequency.length+n.at],o=this.lit&&this.other?`; point ${this.lit} less point ${this.other}: ${Ne(r(this.lit)-r(this.other))} ${s.unit}`:"";R("pointed-curve").textContent=`point ${n.point} at ${s.heard_by[t]}: ${Ne(n.value)} ${s.unit} at ${Ne(s.frequency[n.at],3)} Hz${o}`}table(e){let t=this.now;if(!t)return;let n=[["frequency (Hz)",...t.points.flatMap(s=>t.heard_by.map(r=>`point ${s} at ${r} (${t.unit})`))]];t.frequency.forEach((s,r)=>{n.push([s,...Array.from({length:t.points.length*t.heard_by.length},(o,a)=>Number(t.values[a*t.frequency.length+r].toPrecision(7)))])}),Ji(n,`${e}-${t.quantity}.csv`)}picture(e){let t=this.now;if(!t||!this.plots.length)return;let n=this.titles()[t.quantity],s=devicePixelRatio,r=24*s,o=this.plots.map(h=>h.ctx.canvas),a=q("canvas",{width:String(Math.max(...o.map(h=>h.width))),height:String(o.reduce((h,u)=>h+u.height+r,0))}),c=a.getContext("2d");c.fillStyle=Re("--card"),c.fillRect(0,0,a.width,a.height);let l=0;o.forEach((h,u)=>{c.fillStyle=Re("--ink"),c.font=`${14*s}px system-ui`,c.fillText(`${e}: ${hm(n,t.heard_by[u])}`,12*s,l+17*s),c.drawImage(h,0,l+r),l+=h.height+r}),a.toBlob(h=>h&&Ti(h,`${e}-${t.quantity}.png`))}};function Bl(i,e,t="",n=[]){let s=1/0,r=-1/0;for(let a of i)a<s&&(s=a),a>r&&(r=a);let o=(r-s)*.06||Math.abs(r)*.1||1;return{low:s-o,high:r+o,title:t&&t!=="1"?`${e} (${wi(t)})`:e,labels:n}}function Ci(i,e,t){let n=devicePixelRatio,s=Math.round(e*n),r=Math.round(t*n);(i.width!==s||i.height!==r||!i.style.width)&&(i.width=s,i.height=r,i.style.width=`${e}px`,i.style.height=`${t}px`),i.getContext("2d",{willReadFrequently:!0}).reset()}var wr=58,Au=10,Ru=8;function dm(i,e,t,n,s){Ci(i,e,t);let r=i.getContext("2d");r.scale(devicePixelRatio,devicePixelRatio);let o=n.labels.length>0,a=o?74:38,c=u=>wr+(u-n.low)/(n.high-n.low)*(e-wr-Au),l=u=>t-a-(u-s.low)/(s.high-s.low)*(t-Ru-a);r.font="11px system-ui",r.lineWidth=1,r.strokeStyle=Re("--grid"),r.fillStyle=Re("--ink-soft"),r.textAlign="center",r.textBaseline="top";let h=nv(n,(e-wr-Au)/70);for(let u of h)um(r,c(u),Ru,c(u),t-a),r.save(),r.translate(c(u),t-a+4),o&&(r.rotate(-Math.PI/7),r.textAlign="right"),r.fillText(iv(n,u),o?8:0,0,o?Math.min(95,c(u)):70),r.restore();r.textAlign="right",r.textBaseline="middle";for(let u of nv(s,(t-Ru-a)/34))um(r,wr,l(u),e-Au,l(u)),r.fillText(iv(s,u),wr-5,l(u),wr-20);return r.fillStyle=Re("--ink"),r.textAlign="center",r.textBaseline="bottom",r.fillText(n.title,(wr+e-Au)/2,t-2,e-wr),r.save(),r.translate(2,(Ru+t-a)/2),r.rotate(-Math.PI/2),r.textBaseline="top",r.fillText(s.title,0,0,t-a),r.restore(),{c:r,x:c,y:l}}function um(i,e,t,n,s){i.beginPath(),i.moveTo(e,t),i.lineTo(n,s),i.stroke()}function nv(i,e){if(i.labels.length)return i.labels.map((o,a)=>a);let t=(i.high-i.low)/Math.max(e,2),n=10**Math.floor(Math.log10(t)),s=[1,2,5,10].map(o=>o*n).find(o=>o>=t),r=[];for(let o=Math.ceil(i.low/s);o*s<=i.high;o++)r.push(o*s);return r}function iv(i,e){return i.labels[e]??Ne(e,3)}function fm(i,e){let t=i.map(l=>l.map(h=>typeof h=="number"?Ne(h):h)),n=22,s=12,r=document.createElement("canvas"),o=r.getContext("2d");o.font="13px system-ui";let a=t[0].map((l,h)=>Math.max(...t.map(u=>o.measureText(u[h]??"").width))+2*s);Ci(r,a.reduce((l,h)=>l+h,0),n*i.length);let c=r.getContext("2d");c.scale(devicePixelRatio,devicePixelRatio),c.font="13px system-ui",c.textBaseline="middle",c.strokeStyle=Re("--grid"),t.forEach((l,h)=>{c.fillStyle=Re(h?"--ink":"--ink-soft");let u=s;l.forEach((d,f)=>{c.fillText(d,u,(h+.5)*n),u+=a[f]}),um(c,0,(h+1)*n,u,(h+1)*n)}),zl([r],e)}function zl(i,e,t=3){let n=i.filter(l=>l.width>0&&l.height>0);if(!n.length)return;let s=Math.max(...n.map(l=>l.width)),r=Math.max(...n.map(l=>l.height)),o=Math.min(t,n.length),a=document.createElement("canvas");a.width=o*s,a.height=Math.ceil(n.length/o)*r;let c=a.getContext("2d");c.fillStyle=Re("--card"),c.fillRect(0,0,a.width,a.height),n.forEach((l,h)=>c.drawImage(l,h%o*s,Math.floor(h/o)*r)),a.toBlob(l=>l&&Ti(l,e))}var TA="#c9c4ba";function sv(i){let[e,t]=new Uint32Array(i,0,2),n=8+12*e;return{corners:new Float32Array(i,8,3*e),facets:new Uint32Array(i,n,3*t),faces:new Uint32Array(i,n+12*t,t)}}var Cu=class{constructor(e,t,n){this.faces=e;let s=n.length/3,r=new Float32Array(9*s);this.normals=new Float32Array(3*s),this.middles=new Float32Array(3*s),this.areas=new Float32Array(s);let[o,a,c]=[new V,new V,new V];for(let h=0;h<s;h++){[o,a,c].forEach((d,f)=>{d.fromArray(t,3*n[3*h+f]),Ks(d.toArray()).toArray(r,9*h+3*f)}),o.clone().add(a).add(c).divideScalar(3).toArray(this.middles,3*h);let u=a.clone().sub(o).cross(c.clone().sub(o));this.areas[h]=u.length()/2,u.normalize().toArray(this.normals,3*h)}let l=new Vn;l.setAttribute("position",new ln(r,3)),l.setAttribute("color",new ln(new Float32Array(9*s),3)),l.setAttribute("normal",new ln(this.smooth(n,t.length/3),3)),this.mesh=new Zt(l,new Hs({vertexColors:!0,roughness:.7,transparent:!0,side:fi})),this.mesh.renderOrder=-1,this.group.add(this.mesh)}faces;group=new ni;mesh;normals;middles;areas;marks=[];smooth(e,t){let n=new Uint32Array(t+1),s=new Uint32Array(e.length),r=new Float32Array(3*e.length);for(let h of e)n[h+1]++;for(let h=0;h<t;h++)n[h+1]+=n[h];let o=n.slice();e.forEach((h,u)=>{s[o[h]++]=Math.floor(u/3)});let a=new V,c=new V,l=new V;return e.forEach((h,u)=>{a.fromArray(this.normals,3*Math.floor(u/3)),l.set(0,0,0);for(let d=n[h];d<n[h+1];d++)c.fromArray(this.normals,3*s[d]),a.dot(c)>.82&&l.addScaledVector(c,this.areas[s[d]]);Ks(l.normalize().toArray()).normalize().toArray(r,3*u)}),r}inside(e){let t=new Set(e.faces),n=e.normal,s=n?new V().fromArray(n.towards).normalize():null,r=n?Math.cos(Math.PI*n.within/180):-1,o=new V,a=e.above.map(c=>({point:new V().fromArray(c.point),normal:new V().fromArray(c.normal)}));return c=>t.size&&!t.has(this.faces[c])||s&&o.fromArray(this.normals,3*c).dot(s)<r?!1:a.every(l=>o.fromArray(this.middles,3*c).sub(l.point).dot(l.normal)>=0)}paint(e,t){let n=this.inside(e.region),s=new Set(e.forbidden),[r,o,a]=[Re("--good"),TA,Re("--bad")].map(u=>new Ke(u)),c=this.mesh.geometry.getAttribute("color"),l=0,h=0;for(let u=0;u<this.areas.length;u++){let d=n(u),f=d?r:s.has(this.faces[u])?a:o;h+=this.areas[u],d&&(l+=this.areas[u]);for(let p=0;p<3;p++)c.setXYZ(3*u+p,f.r,f.g,f.b)}return c.needsUpdate=!0,this.mesh.material.opacity=t?.4:1,this.mesh.material.depthWrite=!t,this.mark(e.microphones),l/h}mark(e){for(let n of this.marks)n.removeFromParent(),n.geometry.dispose();let t=this.mesh.geometry.boundingSphere?.radius??(this.mesh.geometry.computeBoundingSphere(),this.mesh.geometry.boundingSphere.radius);this.marks=e.map(n=>{let s=new Zt(new Wr(.03*t,16,12),new ui({color:Re("--ink")}));return s.position.copy(Ks(n.at)),s.name=n.name,this.group.add(s),s})}hit(e){if(e.object!==this.mesh||e.faceIndex===void 0||e.faceIndex===null)return null;let{x:t,y:n,z:s}=e.point.clone().sub(this.group.position),r=e.faceIndex;return{face:this.faces[r],at:[1e3*t,-1e3*s,1e3*n],normal:[...this.normals.subarray(3*r,3*r+3)]}}dispose(){this.group.removeFromParent(),this.mesh.geometry.dispose(),this.mesh.material.dispose(),this.mark([])}};async function Tr(i,e,t){let n="The studio does not answer.";try{let s=await fetch(`${i}?${new URLSearchParams(e)}`,{method:"POST",body:t,headers:yo()});if(s.ok)return s;n=`The studio rejected it (${s.status}).`,n=(await s.json()).message}catch{}throw new Error(n)}async function rv(i,e,t){let n={};for(let s of t){let r=new Uint8Array(await s.arrayBuffer()),o="";for(let a=0;a<r.length;a+=32768)o+=String.fromCharCode(...r.subarray(a,a+32768));n[s.name]=btoa(o)}return(await Tr(i,e,JSON.stringify(n))).json()}var hv=/\.(step|stp|stl|3mf|obj|ply)$/i,ov=["pitch","base","edge","port_step","length_step","seed"],av=["seat","tubes"],lv={unit:"mm",seat:"on",base:.4,edge:.4,port_step:15,tubes:"as they lie",length_step:.5,seed:0},cv=60;function Hl(i){let e=R(i).value.replace("\u2212","-").replace(",",".").trim();return e===""?null:Number.isFinite(Number(e))?Number(e):e}function Pu(i,e=3){return`(${i.map(t=>Ne(t,e)).join(", ")})`}var Iu=class{constructor(e,t,n){this.array=e;this.send=t;this.session=n;R("body-file").addEventListener("change",s=>{let r=s.target,o=r.files?.[0];o&&this.handIn(o),r.value=""});for(let s of["body-unit","body-skin"])R(s).addEventListener("change",()=>this.ask());R("region-clear").addEventListener("click",()=>this.choose({region:{faces:[],normal:null,above:[],least_radius:null}})),R("region-least").addEventListener("change",()=>this.choose({region:{...this.chosen.region,least_radius:Hl("region-least")}})),R("region-faces").addEventListener("change",()=>this.choose({region:{...this.chosen.region,faces:R("region-faces").value.split(",").map(Number).filter(s=>Number.isInteger(s)&&s>0)}})),R("fit-run").addEventListener("click",()=>this.fit()),R("fit-stop").addEventListener("click",()=>this.send({do:"stop",stage:"fit"})),R("fit-save").addEventListener("click",()=>this.send({do:"fitted-files"}))}array;send;session;body=null;view=null;stated=null;taken="";chosen={region:{faces:[],normal:null,above:[],least_radius:null},forbidden:[],microphones:[]};open=!1;asked="";opened(e){this.open=e,e&&!this.asked&&this.ask(),this.show()}begin(){this.asked="",this.open&&this.ask()}take(e){this.stated=e;let t=JSON.stringify(e.surface??null);if(t!==this.taken){let n=JSON.parse(this.taken||"null")?.body!==e.surface?.body;(e.surface||!this.taken)&&this.fill(e.surface??{}),this.taken=t,n&&(this.asked="")}this.open&&!this.asked&&this.ask(),this.clicks(),this.report(),this.show()}async handIn(e){this.problem("body",""),this.problem("fit","");try{await Tr("/bodies",{session:this.session()??"",name:e.name},e),this.ask()}catch(t){this.problem("body",t.message)}}async learn(e){this.body=e.file===null?null:e,this.problem("body",""),R("body-said").textContent=e.file===null?e.name?`Choose the file ${e.name}, which is not beside the design.`:"Choose the file of the body that the array is to lie on.":`${e.name}: ${e.size.map(t=>Ne(t)).join(" \xD7 ")} mm, ${e.faces>1?`${e.faces} faces`:"one face"}. ${e.findings.join(". ")}`,this.drop(),e.file!==null&&await this.fetch(e.file),R("region-card").hidden=R("fit-card").hidden=this.view===null,R("body-click").value="",this.clicks(),this.show(),document.documentElement.dataset.body=e.file===null?"":e.name}failed(){this.body=null,this.drop(),R("region-card").hidden=R("fit-card").hidden=!0,this.show()}progress(e){R("fit-run").disabled=e!=="",R("fit-stop").disabled=e==="",document.querySelector('[data-status="fit"]').textContent=e}restyle(){this.show()}async fetch(e){try{let t=await fetch(e,{headers:yo()});if(!t.ok)throw new Error;let{corners:n,facets:s,faces:r}=sv(await t.arrayBuffer());this.body?.file===e&&(this.view=new Cu(r,n,s))}catch{this.problem("body","The body could not be fetched from the studio. Choose its file again.")}}drop(){this.array.offer(null),this.view?.dispose(),this.view=null}ask(){this.asked=R("body-unit").value+R("body-skin").value,this.problem("body",""),this.send({do:"body",unit:R("body-unit").value,skin:Hl("body-skin")})||(this.asked="")}fill(e){let t=s=>e[s]??lv[s]??"";R("body-unit").value=t("unit"),R("body-skin").value=String(t("skin"));for(let s of ov)R(`fit-${s}`).value=String(t(s));for(let s of av)R(`fit-${s}`).value=t(s);R("fit-points").value=e.body&&!e.pitch?this.stated.lines.map(s=>s.points).join(", "):"";let n=e.region??{};R("region-least").value=String(n.least_radius??""),this.chosen={region:{faces:n.faces??[],normal:n.normal??null,above:n.above??[],least_radius:n.least_radius??null},forbidden:e.forbidden??[],microphones:e.microphones??[]}}choose(e){this.chosen={...this.chosen,...e},e.region&&e.region.least_radius===null&&(R("region-least").value=""),this.show()}clicks(){let e=R("body-click"),t=e.value,n=(this.body?.faces??1)>1,s=[...n?[["faces","chooses its face"]]:[],["direction","chooses what faces the same way"],...n?[["forbidden","forbids its face to microphones"]]:[],...(this.stated?.microphones??[]).map(r=>[`microphone ${r}`,`places microphone ${r}`])];e.replaceChildren(...s.map(([r,o])=>q("option",{value:r},o))),s.some(([r])=>r===t)&&(e.value=t)}click(e){let t=R("body-click").value,{region:n,forbidden:s,microphones:r}=this.chosen,o=c=>c.includes(e.face)?c.filter(l=>l!==e.face):[...c,e.face].sort((l,h)=>l-h),a=(c,l)=>c.map(h=>Math.round(h*l)/l);if(t==="faces")this.choose({region:{...n,faces:o(n.faces)}});else if(t==="forbidden")this.choose({forbidden:o(s)});else if(t==="direction")this.choose({region:{...n,normal:{towards:a(e.normal,1e3),within:n.normal?.within??cv}}});else{let c=t.slice(11);this.choose({microphones:[...r.filter(l=>l.name!==c),{name:c,at:a(e.at,10)}].sort((l,h)=>l.name.localeCompare(h.name))})}}words(e){let t=R("body-click").value,n=(this.body?.faces??1)>1,s={faces:this.chosen.region.faces.includes(e.face)?"click to leave it out":"click to choose it",forbidden:this.chosen.forbidden.includes(e.face)?"click to allow microphones":"click to forbid microphones",direction:"click to choose what faces the same way"}[t]??`click to place ${t}`;return`${n?`face ${e.face}`:"body"}: ${s}`}show(){if(!(this.open&&this.view!==null))return this.array.offer(null);let t=this.stated?.layout?.frozen?.body!==this.body.sha256,n=this.view.paint(this.chosen,!t);this.array.offer({body:this.view,alone:t,click:l=>this.click(l),words:l=>this.words(l)});let{region:s,forbidden:r,microphones:o}=this.chosen;R("region-said").textContent=`${s.faces.length?`Face${s.faces.length>1?"s":""} ${s.faces.join(", ")}`:s.normal||s.above.length?"All faces":"The whole body"}${s.normal||s.above.length?", as far as the conditions below hold":""}: ${Ne(100*n,2)} % of the surface.`,R("region-faces").value=s.faces.join(", "),R("region-said").dataset.faces=s.faces.join(",");let a=(l,h)=>Ft("\xD7",l,{"aria-label":`remove: ${h}`}),c=[];if(s.normal){let l=q("input",{type:"text",id:"region-within",inputmode:"decimal",size:"4",value:String(s.normal.within),"aria-label":"largest angle, degrees"}),h=s.normal;l.addEventListener("change",()=>this.choose({region:{...s,normal:{...h,within:Hl("region-within")??cv}}})),c.push(q("li",{},"faces within ",l,`\xB0 of ${Pu(h.towards)} `,a(()=>this.choose({region:{...s,normal:null}}),"the direction")))}s.above.forEach((l,h)=>c.push(q("li",{},`above the plane at ${Pu(l.point)} towards ${Pu(l.normal)} `,a(()=>this.choose({region:{...s,above:s.above.filter((u,d)=>d!==h)}}),`plane ${h+1}`)))),r.length&&c.push(q("li",{},`no microphones on face ${r.join(", ")} `,a(()=>this.choose({forbidden:[]}),"forbidden faces")));for(let l of o)c.push(q("li",{},`microphone ${l.name} near ${Pu(l.at)} mm `,a(()=>this.choose({microphones:o.filter(h=>h!==l)}),`place of microphone ${l.name}`)));R("region-parts").replaceChildren(...c)}fit(){this.problem("fit","");let e={unit:R("body-unit").value,skin:Hl("body-skin"),...this.chosen};for(let s of ov)e[s]=Hl(`fit-${s}`)??lv[s]??null;for(let s of av)e[s]=R(`fit-${s}`).value;let t=R("fit-points").value.trim(),n=t===""?null:t.split(",").map(s=>Number(s));if(n?.some(s=>!Number.isInteger(s)))return this.problem("fit",`\u201C${t}\u201D must be a whole number for each line, with commas between them.`);if(!n&&e.pitch===null)return this.problem("fit","Give a pitch, or the number of points.");this.send({do:"fit",surface:e,points:n})&&this.progress("begins")}report(){let e=this.stated.layout?.frozen;R("fit-save").hidden=!e,R("fit-findings").replaceChildren(...(e?.findings??[]).map(n=>q("li",{},n)));let t=e?.cells?.length?Math.max(...e.cells.map(n=>n.distances.at(-1))):null;R("fit-said").textContent=e?`${e.points.length} points are laid on the body without overlaps.${t===null?"":` No place of the region is further than ${Ne(t,2)} mm from a membrane.`}`:""}problem(e,t){document.querySelector(`[data-problem="${e}"]`).textContent=t}};function uv(i,e){let t=10**(Math.floor(Math.log10(i))-1);return Number(((e?Math.ceil(i/t):Math.floor(i/t))*t).toPrecision(6))}function dv(i,e){if(i.kind==="count")return 1;if(e!==0)return 10**(Math.floor(Math.log10(Math.abs(e))+1e-9)-2);let t=i.lowest!==null&&i.highest!==null?i.highest-i.lowest:1;return 10**(Math.floor(Math.log10(t))-2)}function Vl(i,e,t){return Math.min(Math.max(i,e),t)}function fv(i,e,t){let n=dv(i,e),s=Math.sign(t),r=e/n,o=s>0?Math.floor(r+1e-6)+1:Math.ceil(r-1e-6)-1,a=Number(((o+s*(Math.abs(t)-1))*n).toPrecision(6));return e!==0&&Math.sign(a)!==Math.sign(e)&&i.lowest!==null&&i.lowest>=0&&(a=Number((e*.99).toPrecision(3))),Vl(a,i.lowest??-1/0,i.highest??1/0)}function EA(i,e){let{lowest:t,highest:n}=i,s=l=>i.kind==="count"?Math.round(l):l;if(e>0&&!(t!==null&&t<0)&&!(n!==null&&n<=1)){let l=Math.max(t??0,s(uv(e/4,!1)),i.kind==="count"?1:1e-9),h=Math.max(Math.min(n??1/0,s(uv(e*4,!0))),i.kind==="count"?Math.min(6,n??6):0,l*1.0001),u=Math.log(h/l),d=f=>{let p=dv(i,f);return Number((Math.round(f/p)*p).toPrecision(6))};return{from:l,to:h,value:f=>Vl(d(l*Math.exp(f*u)),l,h),share:f=>Vl(Math.log(Math.max(f,1e-12)/l)/u,0,1)}}let r=t??Math.min(0,2*e),o=n??Math.max(1,2*e),a=(o-r)/200,c=l=>i.kind==="count"?Math.round(l):Number((Math.round(l/a)*a).toPrecision(6));return{from:r,to:o,value:l=>Vl(c(r+l*(o-r)),r,o),share:l=>Vl((l-r)/(o-r||1),0,1)}}function pv(i,e,t){return t&&e>=t.from&&e<=t.to?t:EA(i,e)}function pm(i,e){let t=i.map(n=>Math.abs(Math.log(n/Math.max(e,1e-9))));return t.indexOf(Math.min(...t))}var Gl=1e3,AA={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10},Nu=class{constructor(e,t){this.place=e;this.set=t}place;set;rows=new Map;dragged="";gestures=0;scales=new Map;sizes={};bought=!0;build(e,t,n){let s=this.place.contains(document.activeElement)?document.activeElement.id:"",r=new Set([...this.place.querySelectorAll("details[open]")].map(l=>l.dataset.group)),o=this.rows.size===0;this.rows.clear(),this.place.replaceChildren(this.choice());let a=new Map;for(let l of e){if(!a.has(l.group)){let u=q("summary",{},Lu(l.group));n.includes(l.group)&&u.append(Ft("remove",()=>this.set(l.group,null),{class:"remove","aria-label":`remove ${l.group}`}));let d=q("details",{"data-group":l.group,"aria-label":Lu(l.group)},u);d.open=o?["resonator","membrane","tube"].includes(l.group):r.has(l.group),a.set(l.group,d),this.place.append(d)}let h=this.row(l);this.rows.set(l.name,h),a.get(l.group).append(h.row)}let c=q("select",{id:"add-table","aria-label":"add a table that the design does not state"},q("option",{value:""},"add a table\u2026"),...Object.keys(t).map(l=>q("option",{value:l},Lu(l))));c.addEventListener("change",()=>{c.value&&this.set(c.value,t[c.value]),c.value=""}),this.place.append(q("p",{},c)),s&&document.getElementById(s)?.focus()}choice(){let e=q("input",{type:"checkbox",id:"bought-only"});return e.checked=this.bought,e.addEventListener("change",()=>{this.bought=e.checked;for(let n of this.rows.values())this.sizes[n.field.name]&&n.show(n.field.value)}),q("p",{class:"choice",title:"sliders of tubes and membranes stop at sizes that can be bought, and wire and sheath follow the bore"},e,q("label",{for:"bought-only"},"Parts that can be bought"))}offer(e){let t=this.sizes;this.sizes=e;for(let[n,s]of this.rows)n!==this.dragged&&String(t[n])!==String(e[n])&&s.show(s.field.value)}stops(e){let n=(this.bought?this.sizes[e.name]??[]:[]).filter(s=>s>=(e.lowest??-1/0)&&s<=(e.highest??1/0));return n.length>1?n:null}hint(e,t){let n=new Set(e);for(let[s,{row:r,field:o}]of this.rows){if(r.hidden=n.has(s),!o.optional)continue;let a=t[s],c=r.querySelector(".value"),l=a===void 0?"default":typeof a=="number"?`(${Ne(a)})`:a;c instanceof HTMLSelectElement?c.options[0].textContent=a===void 0?"default":`default: ${a}`:c.setAttribute("placeholder",l)}}update(e){for(let[t,n]of Object.entries(e)){let s=this.rows.get(t);s&&(s.field.value=n,t!==this.dragged&&s.show(n))}}settle(e=""){for(let t of this.place.querySelectorAll(".refused, .concerned")){let n=this.rows.get(t.dataset.name);n&&t.classList.contains("refused")&&![e,this.dragged].includes(n.field.name)&&n.show(n.field.value),t.classList.remove("refused","concerned"),t.querySelector(".refusal")?.replaceChildren(),t.querySelector("[aria-invalid]")?.removeAttribute("aria-invalid")}}refuse(e,t,n,s){this.settle(e);let r=this.rows.get(e);if(!r)return!1;r.row.closest("details").open=!0,r.row.hidden=!1,r.row.classList.add("refused"),r.row.querySelector(".value")?.setAttribute("aria-invalid","true");let o=r.row.querySelector(".refusal");if(o.append(q("span",{},t)),n&&!t.includes(n)&&o.append(q("span",{},` The field alone: ${n}.`)),s!==null){let c=r.field.unit?` ${r.field.unit}`:"";o.append(Ft(`Set ${Ne(s,6)}${c}`,()=>this.set(e,s),{class:"mend"}))}o.scrollIntoView({block:"nearest"});let a=t.match(/(?:^|: )([a-z_]+(?:\.[\w-]+)+)/);return a&&a[1]!==e&&this.rows.get(a[1])?.row.classList.add("concerned"),!0}focus(e){let t=this.rows.get(e);t&&(t.row.closest("details").open=!0,t.row.scrollIntoView({block:"center"}),t.row.querySelector(".value")?.focus())}row(e){let t=`field-${e.name}`,n=[e.description,e.allowed].filter(Boolean).join("; "),s=q("div",{class:"field","data-name":e.name,title:`${e.name}: ${n}`}),r=q("label",{for:t},e.label);s.append(r);let o=this.control(e,t);return s.append(...o.elements),e.unit&&s.append(q("span",{class:"unit"},e.unit)),s.append(q("p",{class:"hint",id:`${t}-hint`},n),q("p",{class:"refusal",role:"alert"})),o.elements[0].setAttribute("aria-describedby",`${t}-hint`),o.show(e.value),{field:e,row:s,show:o.show}}control(e,t){if(e.choices.length){let n=q("select",{id:t,class:"value"},...e.choices.map(s=>q("option",{},s)));return n.addEventListener("change",()=>this.set(e.name,n.value)),{elements:[n],show:s=>{n.value=s}}}if(e.suggestions.length&&(e.value===null||e.suggestions.includes(e.value)))return this.known(e,t);if(e.kind==="flag"){let n=q("input",{id:t,class:"value",type:"checkbox"});return n.addEventListener("change",()=>this.set(e.name,n.checked)),{elements:[n],show:s=>{n.checked=s}}}return e.kind==="text"||e.kind==="list"?this.textual(e,t):this.numeric(e,t)}known(e,t){let n=q("select",{id:t,class:"value"},...e.optional?[q("option",{value:""},"default")]:[],...e.suggestions.map(s=>q("option",{},s)));return n.addEventListener("change",()=>this.set(e.name,n.value||null)),{elements:[n],show:s=>{n.value=s??""}}}textual(e,t){let n=q("input",{id:t,class:"value text",type:"text",autocomplete:"off",spellcheck:"false"}),s=e.kind==="list"&&(e.value??[]).some(r=>typeof r=="number");return n.addEventListener("change",()=>{let r=n.value.split(",").map(a=>a.trim()).filter(Boolean),o=n.value===""&&e.optional?null:n.value;this.set(e.name,e.kind==="text"||o===null?o:s?r.map(Number):r)}),{elements:[n],show:r=>{n.dataset.shown=n.value=Array.isArray(r)?r.join(", "):r??""}}}numeric(e,t){let n=q("input",{id:t,class:"value",type:"text",inputmode:"decimal",autocomplete:"off"}),s=q("input",{type:"range",min:"0",max:String(Gl),class:"slider","aria-label":`${Lu(e.group)} ${e.label}, slider`}),r=q("datalist",{id:`${t}-sizes`}),o=q("span",{class:"slider-ends","aria-hidden":"true"});s.setAttribute("list",r.id);let a="";n.addEventListener("change",()=>{let h=n.value.replace("\u2212","-").replace(",",".").trim();h===""&&e.optional?this.set(e.name,null):this.set(e.name,h===""||!Number.isFinite(Number(h))?n.value:Number(h))});let c=(h,u)=>{a||(a=`${e.name}-${++this.gestures}-${Date.now()}`),n.value=String(h),s.setAttribute("aria-valuetext",`${h} ${e.unit}`),this.set(e.name,h,a,u)};s.addEventListener("input",()=>{this.dragged=e.name;let h=this.stops(e);c(h?h[Number(s.value)]:this.scales.get(e.name).value(Number(s.value)/Gl),h!==null)}),s.addEventListener("change",()=>{a="",this.dragged="",this.rows.get(e.name)?.row.classList.contains("refused")||l(e.value)}),s.addEventListener("keydown",h=>{let u=AA[h.key];if(!u||h.ctrlKey||h.metaKey||h.altKey)return;h.preventDefault(),h.repeat||(a="");let d=Number(n.value),f=this.stops(e);if(!Number.isFinite(d))return;let p=f?f[Math.min(Math.max(pm(f,d)+Math.sign(u),0),f.length-1)]:fv(e,d,u);p!==d&&(s.value=String(f?f.indexOf(p):Math.round(this.scales.get(e.name).share(p)*Gl)),c(p,f!==null))}),s.addEventListener("keyup",()=>{a=""});let l=h=>{if(n.dataset.shown=n.value=h==null?"":String(h),s.disabled=typeof h!="number",typeof h!="number")return;let u=this.stops(e);s.max=String(u?u.length-1:Gl),s.setAttribute("aria-valuetext",`${h} ${e.unit}`),r.childElementCount!==(u??[]).length&&r.replaceChildren(...(u??[]).map((v,g)=>q("option",{value:String(g)})));let d=pv(e,h,this.scales.get(e.name));this.scales.set(e.name,d);let[f,p]=u?[u[0],u.at(-1)]:[d.from,d.to];o.replaceChildren(q("span",{},Ne(f,3)),q("span",{},Ne(p,3))),s.value=String(u?pm(u,h):Math.round(d.share(h)*Gl))};return{elements:[n,s,r,o],show:l}}};function Lu(i){return i===""?"array":i.replace(/^lines\.(\d+)/,(e,t)=>`line ${Number(t)+1}`).replaceAll("_"," ").replaceAll(".",": ")}var mv="acoustic-fem-studio",Du="acoustic-fem-studio-last";function gv(i){try{sessionStorage.setItem(mv,JSON.stringify(i)),i.unsaved?localStorage.setItem(Du,JSON.stringify(i)):mm()?.session===i.session&&localStorage.removeItem(Du)}catch{}}function Ou(){return _v(sessionStorage,mv)}function mm(){return _v(localStorage,Du)}function xv(){try{localStorage.removeItem(Du)}catch{}}function _v(i,e){try{return JSON.parse(i.getItem(e)??"null")}catch{return null}}async function vv(i){let e=new Blob([JSON.stringify(i)]).stream().pipeThrough(new CompressionStream("deflate-raw")),t=new Uint8Array(await new Response(e).arrayBuffer()),n=btoa(String.fromCharCode(...t)).replaceAll("+","-").replaceAll("/","_").replaceAll("=","");return`${location.origin}/#design=${n}`}async function yv(){if(!location.hash.startsWith("#design="))return null;let i=location.hash.slice(8);history.replaceState(null,"","/");let e=Uint8Array.from(atob(i.replaceAll("-","+").replaceAll("_","/")),r=>r.charCodeAt(0)),t=new Blob([e]).stream().pipeThrough(new DecompressionStream("deflate-raw")).pipeThrough(new TextDecoderStream).getReader(),n="";for(let r=await t.read();!r.done;r=await t.read())if(n+=r.value,n.length>262144)throw await t.cancel(),new Error("no design is as long");let s=JSON.parse(n);if(typeof s!="object"||Array.isArray(s))throw new Error("no table");return s}var bv=22,Sv=[["point","",i=>String(i.number)],["top-1 accuracy","%",i=>Ne(100*i.named,3)],["hardest to tell from","",i=>String(i.nearest)],["distance","",i=>Ne(i.distance,3)],["level","dB",i=>Ne(i.level,3)],["phase","\xB0",i=>Ne(i.phase,3)],["smallest detectable force","nN",i=>Ne(1e9*i.force,3)]],Uu=class{constructor(e,t,n,s){this.word=e;this.colourOf=t;this.choose=n;this.hover=s;let r=R("confusion");r.addEventListener("pointermove",o=>this.read(o)),r.addEventListener("pointerleave",()=>{R("pointed-cell").textContent="\xA0",this.hover(null)}),r.addEventListener("click",o=>{let a=this.under(o);a&&this.choose(this.now.points[a[0]].number,o.shiftKey)})}word;colourOf;choose;hover;now=null;lit=null;pointed=null;cell=1;get figures(){return this.now?.figures??{}}take(e){this.now=e,this.draw()}light(e){this.lit=e;for(let t of R("points-table").querySelectorAll("tr[data-point]"))t.classList.toggle("lit",t.dataset.point===String(e));this.matrix()}point(e){if(e!==this.pointed){this.pointed=e;for(let t of R("points-table").querySelectorAll("tr[data-point]"))t.classList.toggle("pointed",t.dataset.point===String(e));R("confusion").clientWidth&&this.matrix()}}recolour(){for(let e of R("points-table").querySelectorAll("tr[data-point]"))e.querySelector(".swatch").style.background=this.colourOf(Number(e.dataset.point))}under(e){let t=R("confusion").getBoundingClientRect(),n=this.now?.points.length??0,[s,r]=[e.clientX-t.left,e.clientY-t.top].map(o=>Math.floor((o-bv)/this.cell));return r>=0&&s>=0&&r<n&&s<n?[r,s]:null}read(e){let t=this.under(e),n=this.now;if(!t||!n)return this.hover(null);let[s,r]=t.map(o=>n.points[o].number);R("pointed-cell").textContent=`point ${s} located as ${r}: ${n.confusion[t[0]][t[1]]} of ${n.touches} touches`,this.hover(s)}asBuilt(e){R("as-built").textContent=`Taps and presses on ${e.sensors} as-built sensors, not calibrated: top-1 accuracy ${Ne(100*e.mean,3)} % (${Ne(100*e.interval[0],2)} to ${Ne(100*e.interval[1],2)} %), 5th percentile ${Ne(100*e.worst,3)} %. Multi-sine touches: ${Ne(100*e.multi_sines,3)} %.`}draw(){let e=this.now;R("figures").replaceChildren(...Object.entries(e.figures).map(([r,o])=>{let a=this.word()[r];return q("div",{title:a.definition,"data-figure":r},q("dt",{},a.title),q("dd",{},Js(o,a.unit)))})),R("points-fidelity").textContent=`Fidelity ${e.fidelity}.`,R("hardest").textContent=`Hardest to tell apart: ${e.hardest.map(r=>r.join(" and ")).join("; ")}.`;let t=e.overlaps.length?`Cannot be built: ${e.overlaps.join("; ")}${e.mend?`; ${e.mend}`:""}`:"";R("overlaps").textContent=t;let n=q("tr",{},...Sv.map(([r,o])=>q("th",{scope:"col"},o?`${r} (${o})`:r))),s=e.points.map(r=>{let o=q("tr",{"data-point":String(r.number),tabindex:"0"},...Sv.map(([,,l])=>q("td",{},l(r)))),a=q("span",{class:"swatch"});a.style.background=this.colourOf(r.number),o.firstElementChild.prepend(a);let c=(l=!1)=>this.choose(this.lit===r.number?null:r.number,l);return o.addEventListener("click",l=>c(l.shiftKey)),o.addEventListener("pointerenter",()=>this.hover(r.number)),o.addEventListener("pointerleave",()=>this.hover(null)),o.addEventListener("keydown",l=>{(l.key==="Enter"||l.key===" ")&&(l.preventDefault(),c())}),o});R("points-table").replaceChildren(q("thead",{},n),q("tbody",{},...s)),this.light(this.lit)}matrix(){let e=this.now,t=R("confusion");if(!e)return;let n=e.confusion.length,s=this.cell=Math.max(Math.floor(340/n),3),r=bv,o=devicePixelRatio;t.width=t.height=(n*s+r)*o,t.style.width=t.style.height=`${n*s+r}px`;let a=t.getContext("2d");a.scale(o,o),a.font="10px system-ui",a.textAlign="center",a.textBaseline="middle";let c=Math.ceil(n/14);for(let h=0;h<n;h++){a.fillStyle=Re("--ink-soft"),h%c===0&&(a.fillText(String(e.points[h].number),r+(h+.5)*s,r/2),a.fillText(String(e.points[h].number),r/2,r+(h+.5)*s));for(let u=0;u<n;u++){let d=e.confusion[h][u]/e.touches;a.globalAlpha=d===0?.07:.25+.75*Math.sqrt(d),a.fillStyle=d===0?Re("--ink-soft"):h===u?Re("--good"):Re("--bad"),a.fillRect(r+u*s,r+h*s,s-1,s-1),a.globalAlpha=1,s>=24&&d>0&&(a.fillStyle=Re(h===u&&d>.5?"--card":"--ink"),a.fillText(Ne(100*d,2),r+(u+.5)*s,r+(h+.5)*s))}}for(let[h,u]of[[this.pointed,"--ink"],[this.lit,"--accent"]]){let d=e.points.findIndex(f=>f.number===h);d<0||(a.strokeStyle=Re(u),a.lineWidth=2,a.strokeRect(r,r+d*s,n*s-1,s-1))}let l=e.points.filter(h=>h.named<1).length;t.setAttribute("aria-label",`predicted confusion of ${n} points; ${l} of them are not always assigned to the correct point; the table beside has the figures`)}restyle(){this.matrix(),this.recolour()}table(e){if(!this.now)return;let t=["number","named","nearest","distance","level","phase","force","loudest","coverage"];Ji([["point","top-1 accuracy","hardest to tell from","distance","level (dB)","phase (degrees)","smallest detectable force (N)","level at 100 Hz, loudest microphone (dB)","coverage of its area",...this.now.points.map(n=>`assigned to ${n.number}, of ${this.now.touches} touches`)],...this.now.points.map((n,s)=>[...t.map(r=>n[r]),...this.now.confusion[s]])],`${e}-points.csv`)}picture(e){R("confusion").toBlob(t=>t&&Ti(t,`${e}-confusion.png`))}};function Js(i,e){return e==="N"&&i!==0&&Math.abs(i)<.001?Math.abs(i)<1e-6?`${Ne(1e9*i)} nN`:`${Ne(1e6*i)} \xB5N`:`${Ne(i)}${e&&e!=="1"?` ${wi(e)}`:""}`}var Mv=10,Fu=class{constructor(e,t){this.points=e;this.show=t}points;show;mole=null;hit=0;left=0;begun=0;play(){[this.hit,this.left,this.begun]=[0,Mv,performance.now()],this.pop()}whack(e){if(this.mole!==null){if(e.includes(this.mole)&&(this.hit+=1),this.left-=1,this.left>0)return this.pop();this.end(`${this.hit} of ${Mv} moles hit in ${Ne((performance.now()-this.begun)/1e3,3)} s`)}}check(){this.mole!==null&&this.mole>this.points()&&this.end("the array has other points now")}pop(){let e=this.mole,t=this.points();if(!(t<2)){for(;this.mole===e;)this.mole=1+Math.floor(Math.random()*t);R("score").dataset.mole=String(this.mole),R("score").textContent=`The mole is at point ${this.mole}. Hit: ${this.hit}; still to come: ${this.left}.`,this.show()}}end(e){this.mole=null,delete R("score").dataset.mole,R("score").textContent=`Over: ${e}.`,this.show()}};var gm=34,Wl=16,ku=class{seconds=0;constructor(e){R("timeline").addEventListener("click",t=>{let n=R("timeline").getBoundingClientRect();this.seconds&&e((t.clientX-n.left)/n.width*this.seconds)})}draw(e,t){let n=R("timeline"),s=n.parentElement.clientWidth;if(n.hidden=e===null,!e||!s)return;let r=this.seconds=e.samples/1e3,o=c=>c/r*s;Ci(n,s,gm);let a=n.getContext("2d");a.scale(devicePixelRatio,devicePixelRatio),a.fillStyle=Re("--grid"),a.fillRect(0,0,s,Wl),a.font="11px system-ui",a.textBaseline="middle",a.textAlign="center";for(let c of e.paths??[]){if(c.length<=0)continue;a.fillStyle=Re("--good");let[l,h]=[c.places[0][0],c.places.at(-1)[0]];a.fillRect(o(l),Wl,Math.max(o(h-l),2),3)}for(let[c,l,h]of e.touches){let u=o(c),d=Math.max(o(l)-u,2);a.globalAlpha=t!==null&&c>t?.45:1,a.fillStyle=Re("--accent"),a.fillRect(u,0,d,Wl),a.fillStyle=Re("--card"),d>14&&a.fillText(String(h),u+d/2,Wl/2)}a.globalAlpha=1,a.fillStyle=Re("--ink-soft"),a.textAlign="left",a.fillText(t===null?"":`${Ne(Math.round(10*t)/10)} s`,0,gm-6),a.textAlign="right",a.fillText(`${Ne(Math.round(10*r)/10)} s`,s,gm-6),t!==null&&(a.fillStyle=Re("--ink"),a.fillRect(o(t)-1,0,2,Wl+4)),n.setAttribute("aria-label",`${e.touches.length} touches located within ${Ne(r,3)} s; the line below says which`)}};var ba=1e3,Xl=250,RA=18,wv="Click a membrane to touch it, drag to slide over the array.";function Tv(i){let e=1e-9;for(let t of i)for(let n=0;n<t.length;n++)e=Math.max(e,Math.abs(t[n]));return e}var Bu=class{constructor(e,t){this.send=e;this.lit=t;let n=R("plan");n.addEventListener("pointerdown",s=>{this.dragged=this.placeOf(s)}),n.addEventListener("click",s=>{let r=this.dragged,o=this.placeOf(s),a=this.under(s);this.dragged=null,r&&Math.hypot(o[0]-r[0],o[1]-r[1])>2*this.points[0]?.[2]?this.slide(r,o):a&&this.press(a)}),R("game").addEventListener("click",()=>this.game.play()),R("write").addEventListener("click",()=>this.write()),R("touch-kind").addEventListener("change",s=>{for(let r of["letter","write"])R(r).hidden=s.target.value!=="letter"}),new ResizeObserver(()=>this.draw()).observe(n.parentElement)}send;lit;points=[];revision=-1;run=0;counted=0;heard=null;begun=0;now=-1;named=null;queue=[];game=new Fu(()=>this.points.length,()=>this.draw());timeline=new ku(e=>this.seek(e));again=!1;pictures=0;newly=!1;lightings=[];planned="";shown=null;from=null;dragged=null;live=null;asked=!1;take(e,t){t!==this.revision&&this.forget(),this.revision=t,this.points=e.points,this.game.check(),this.planned="",R("touch-fidelity").textContent=`Fidelity ${e.fidelity}.`,R("touch-points").replaceChildren(...e.points.map((n,s)=>Ft(String(s+1),()=>this.press(s+1),{"aria-label":`touch point ${s+1}`}))),this.draw()}forget(){this.queue=[],this.heard=this.shown=this.from=null,this.name(null),R("answer").textContent=wv;for(let e of["pictures","lit","named"])delete R("answer").dataset[e];R("waves").getContext("2d").clearRect(0,0,1e5,1e5)}failed(){this.heard||(R("answer").textContent=wv)}interrupt(){!this.heard||this.heard.touched!==null||(this.shown=this.heard,this.heard=null,this.name(null))}press(e){let t=R("touch-kind").value,n=this.points[e-1];t==="letter"?this.write():t!=="slide"?(this.interrupt(),R("answer").textContent=`point ${e} is touched\u2026`,this.send({do:"touch",point:e,kind:t})):this.from?this.slide(this.from,n):(this.from=n,R("answer").textContent=`A slide from point ${e} to\u2026 (choose a second one)`)}write(){let e=R("letter").value.toUpperCase();this.interrupt(),R("answer").textContent=`a finger writes ${e}\u2026`,this.send({do:"touch",kind:"letter",letter:e})}slide(e,t){this.from=null,this.interrupt(),R("answer").textContent="a finger slides over the array\u2026",this.send({do:"touch",kind:"slide",start:e.slice(0,2),end:t.slice(0,2)})}hearLive(e){e.samples?(this.live??={names:e.microphones,samples:e.microphones.map(()=>[])},e.samples.forEach((t,n)=>{this.live.samples[n]=[...this.live.samples[n],...t].slice(-ba)}),this.name(e.state==="touch"?e.point:null),R("answer").textContent=this.named?`point ${this.named} (${Ne(100*e.probability,2)} %)`:e.state):(e.fault||e.text)&&(R("answer").textContent=e.text??e.fault),e.event==="up"&&this.game.whack([e.point]),!this.asked&&(this.asked=!0,requestAnimationFrame(()=>{this.asked=!1,this.draw()}))}name(e){return e===this.named?!1:(this.named=e,this.lit(e),!0)}endLive(){this.live=null,this.name(null),this.draw()}hear(e){this.interrupt(),this.queue.push(e),this.heard||this.next()}restyle(){this.draw()}next(){if(this.heard=this.queue.shift()??null,!this.heard)return;this.begun=performance.now(),R("touch-played").textContent=this.said(this.heard),this.pictures=0,this.lightings=[],this.counted=0,this.again=!1;let e=++this.run;requestAnimationFrame(()=>this.frame(e))}frame(e){let t=this.heard;if(!t||e!==this.run)return;let n=t.samples/1e3;this.now=Math.min((performance.now()-this.begun)/1e3,n),this.pictures+=1;let s=null;for(let o of t.decisions)if(o[0]<=this.now)s=o;else break;let r=s&&s[1]==="touch"?s[2]:null;this.newly&&this.lightings.push(Ne(this.now,5)),this.newly=this.name(r)&&r!==null,this.draw(),t.touched===null&&!this.again&&this.count(t),this.now<n?requestAnimationFrame(()=>this.frame(e)):this.finish(t,(performance.now()-this.begun)/1e3)}count(e){for(let[,t,n]of e.touches.slice(this.counted)){if(t>this.now)return;this.counted+=1,this.game.whack([n])}}seek(e){!this.heard&&this.shown&&(this.queue.unshift(this.shown),this.next()),this.begun=performance.now()-1e3*e,this.again=!0}finish(e,t){let n=e.touches.map(([a,c,l,h])=>`point ${l} from ${Ne(a,3)} to ${Ne(c,3)} s (${Ne(100*h,2)} %)`),s=e.touched===null?`${e.kind==="slide"?"A slide":e.kind==="letter"?"A letter":e.kind}: `:`A ${e.kind} on point ${e.touched}; located: `,r=(e.paths??[]).filter(a=>a.length>0).map(a=>`${a.gesture}, ${Ne(a.length,3)} mm`);R("answer").textContent=s+(n.length?n.join(", "):"no touch was detected")+(r.length?`; path: ${r.join("; ")}`:""),e.kinds?R("answer").textContent+=`; recognized: ${e.kinds.map(a=>`${a[3]} (${Ne(100*a[4],2)} %)`).join(", ")||"nothing"}`:e.line&&(R("answer").textContent+="; to recognize the letter, load a recognizer of this array"),R("answer").dataset.pictures=String(Math.round(this.pictures/t)),R("answer").dataset.lit=this.lightings.join(","),R("answer").dataset.named=e.touches.map(a=>a[2]).join(","),e.touched!==null&&!this.again&&this.game.whack(e.touches.map(a=>a[2]));let o=e.touches.at(-1);this.name(o?o[2]:null),this.heard=null,this.shown=e,this.draw(),this.next()}place(e){let t=this.points.map(d=>d[0]),n=this.points.map(d=>d[1]),s=Math.max(...this.points.map(d=>d[2]))*1.4,[r,o,a,c]=[Math.min(...t)-s,Math.max(...t)+s,Math.min(...n)-s,Math.max(...n)+s],l=Math.min(e.width/(o-r),e.height/(c-a)),h=(e.width-l*(o-r))/2,u=(e.height-l*(c-a))/2;return{at:(d,f)=>[h+l*(d-r),e.height-u-l*(f-a)],scale:l}}draw(){this.plan(),this.waves(),this.timeline.draw(this.live?null:this.heard??this.shown,this.heard?this.now:null)}plan(){let e=R("plan"),t=e.parentElement.clientWidth;if(!this.points.length||t===0)return;let n=this.points.map(d=>d[0]),s=this.points.map(d=>d[1]),r=this.live?null:this.heard??this.shown,o=[t,devicePixelRatio,document.documentElement.dataset.theme,this.named,this.game.mole,this.heard?.touched,(r?.paths||r?.line)&&this.now].join();if(o===this.planned)return;this.planned=o;let a=(Math.max(...s)-Math.min(...s)+12)/(Math.max(...n)-Math.min(...n)+12),c=Math.round(Math.min(Math.max(t*a,110),380));Ci(e,t,c);let l=e.getContext("2d"),{at:h,scale:u}=this.place(e);l.textAlign="center",l.textBaseline="middle",this.points.forEach(([d,f,p],v)=>{let[g,m]=h(d,f),y=v+1;l.beginPath(),l.arc(g,m,Math.max(p*u,6*devicePixelRatio),0,7),l.fillStyle=y===this.named?Re("--accent"):Re("--button"),l.fill(),l.lineWidth=(y===this.game.mole?5:1)*devicePixelRatio,l.strokeStyle=y===this.game.mole?Re("--good"):Re("--ink-soft"),l.stroke(),this.heard&&y===this.heard.touched&&(l.beginPath(),l.arc(g,m,Math.max(p*u,6*devicePixelRatio)+5*devicePixelRatio,0,7),l.lineWidth=2*devicePixelRatio,l.strokeStyle=Re("--ink"),l.stroke()),l.fillStyle=y===this.named?Re("--card"):Re("--ink"),l.font=`${Math.max(Math.min(p*u,14*devicePixelRatio),9*devicePixelRatio)}px system-ui`,l.fillText(String(y),g,m)}),this.paths(l,h,u)}waveforms(){if(this.live)return{names:this.live.names,of:n=>this.live.samples[n],until:this.live.samples[0].length,most:Tv(this.live.samples)};let e=this.heard??this.shown;if(!e)return null;let t=n=>e.values.subarray(n*e.samples,(n+1)*e.samples);return{names:e.microphones,of:t,until:this.heard?Math.floor(this.now*1e3):e.samples,most:e.most??=Tv([e.values])}}paths(e,t,n){let s=this.heard??this.shown;if(!(this.live||!s)){e.fillStyle=Re("--accent");for(let[r,o,a,c]of s.line??[]){if(this.heard&&r>this.now)break;e.globalAlpha=Math.min(c,1);let l=Math.max(n,2*devicePixelRatio),[h,u]=t(o,a);e.fillRect(h-l/2,u-l/2,l,l)}e.globalAlpha=1,e.strokeStyle=e.fillStyle=Re("--accent"),e.lineWidth=3*devicePixelRatio;for(let r of s.paths??[]){let o=r.places.filter(c=>!this.heard||c[0]<=this.now),a=o.at(-1);a&&(r.length>0&&(e.beginPath(),o.forEach(([,c,l,,h],u)=>{h&&u&&o[u-1][4]?e.lineTo(...t(c,l)):e.moveTo(...t(c,l))}),e.stroke()),e.globalAlpha=r.length>0?.25:.4,e.beginPath(),e.arc(...t(a[1],a[2]),Math.max(a[3]*n,4*devicePixelRatio),0,7),e.fill(),e.globalAlpha=1)}}}waves(){let e=R("waves"),t=this.waveforms(),n=e.parentElement.clientWidth;if(!t||n===0)return;let{names:s,of:r,until:o,most:a}=t,c=s.length,l=64;Ci(e,n,l*c+RA);let h=e.getContext("2d"),u=Math.max(0,o-ba),d=e.width/ba,f=l*devicePixelRatio;this.times(h,e.width,l*c*devicePixelRatio,u),h.font=`${12*devicePixelRatio}px system-ui`,s.forEach((p,v)=>{let g=r(v),m=(v+.5)*f;h.strokeStyle=Re("--grid"),h.lineWidth=1,h.beginPath(),h.moveTo(0,m),h.lineTo(e.width,m),h.stroke(),h.strokeStyle=Re("--accent"),h.lineWidth=1.3*devicePixelRatio,h.beginPath();for(let y=u;y<o;y++)h.lineTo((y-u)*d,m-g[y]/a*f*.44);h.stroke(),h.fillStyle=Re("--ink-soft"),h.fillText(`${p}, \xB1${Ne(a,2)} Pa`,6*devicePixelRatio,v*f+14*devicePixelRatio)})}times(e,t,n,s){e.font=`${11*devicePixelRatio}px system-ui`,e.fillStyle=Re("--ink-soft"),e.strokeStyle=Re("--grid"),e.lineWidth=devicePixelRatio;for(let r=Math.ceil(s/Xl)*Xl;r<=s+ba;r+=Xl){let o=(r-s)/ba*t;e.beginPath(),e.moveTo(o,0),e.lineTo(o,n),e.stroke(),e.textAlign=r-s<Xl/4?"left":s+ba-r<Xl/4?"right":"center",e.fillText(`${Ne(r/1e3)} s`,o,n+12*devicePixelRatio)}e.textAlign="left"}said(e){return e.touched===null&&e.kind!=="slide"&&e.kind!=="letter"?`Plays the recording ${e.kind}, ${e.full_scale?`with a full scale of ${Ne(e.full_scale)} Pa`:"which holds pascals"}.`:"Plays the sensor as designed, with the noise of its microphones and without sound of the room."}table(e){let t=this.waveforms(),n=this.live?[]:(this.heard??this.shown)?.decisions??[];if(!t)return;let s=-1,r=Array.from({length:t.until},(o,a)=>{for(;s+1<n.length&&n[s+1][0]<=a/1e3;)s+=1;return[a/1e3,...t.names.map((c,l)=>t.of(l)[a]),s>=0&&n[s][1]==="touch"&&n[s][2]||""]});Ji([["time (s)",...t.names.map(o=>`${o} (Pa)`),"located point"],...r],`${e}-touch.csv`)}picture(e){zl([R("plan"),R("waves")],`${e}-touch.png`,1)}placeOf(e){let t=R("plan"),n=t.getBoundingClientRect(),{at:s,scale:r}=this.place(t),[o,a]=s(0,0),c=(e.clientX-n.left)*(t.width/n.width),l=(e.clientY-n.top)*(t.height/n.height);return[(c-o)/r,(a-l)/r]}under(e){let t=R("plan"),n=t.getBoundingClientRect(),{at:s,scale:r}=this.place(t),o=(e.clientX-n.left)*(t.width/n.width),a=(e.clientY-n.top)*(t.height/n.height),c=null,l=1/0;return this.points.forEach(([h,u,d],f)=>{let[p,v]=s(h,u),g=Math.hypot(p-o,v-a);g<Math.max(d*r,6*devicePixelRatio)*1.3&&g<l&&(l=g,c=f+1)}),c}async sound(){let e=this.heard??this.shown;if(!e)return;let t=8,n=new AudioContext,s=n.createBuffer(Math.min(e.microphones.length,2),e.samples*t,8e3);for(let o=0;o<s.numberOfChannels;o++){let a=e.values.subarray(o*e.samples,(o+1)*e.samples),c=s.getChannelData(o),l=1e-9;for(let h of a)l=Math.max(l,Math.abs(h));for(let h=0;h<c.length;h++){let u=h/t,d=Math.floor(u),f=Math.min(d+1,a.length-1);c[h]=(a[d]+(u-d)*(a[f]-a[d]))/l}}let r=n.createBufferSource();r.buffer=s,r.connect(n.destination),r.onended=()=>n.close(),r.start()}};var Ev=3,zu=class{constructor(e,t){this.place=e;this.apply=t}place;apply;outcome="";rows=[];take(e){this.outcome=e.outcome,this.rows=e.rows.map(([s,r])=>[s,br(r)]),this.place.dataset.outcome=e.outcome.replaceAll(" ","-");let t=e.reasons.slice(0,Ev).map(({words:s,remedy:r})=>{let o=q("li",{},`${br(s)}. `);return r&&o.append(Ft("Fix",()=>this.apply(r.changes),{title:r.line}),q("span",{class:"note"},` ${r.line}`)),o}),n=e.reasons.slice(Ev).map(s=>s.rule);n.length&&t.push(q("li",{},`also: ${n.join(", ")}`)),t.push(...e.clipped.map(s=>q("li",{class:"note"},br(s)))),this.place.replaceChildren(q("strong",{},e.outcome),q("ul",{},...t),q("dl",{},...e.rows.flatMap(([s,r,o])=>[q("dt",{title:o},s),q("dd",{},br(r))])))}};var Hu=class{constructor(e,t,n){this.send=e;this.failed=t;this.end=n;R("live").addEventListener("click",()=>this.turn(!this.on)),R("card").addEventListener("change",()=>{this.on&&this.turn(!0)})}send;failed;end;get on(){return R("live").getAttribute("aria-pressed")==="true"}turn(e){if(R("live").setAttribute("aria-pressed",String(e)),document.querySelector("[data-problem='live']").textContent="",!e){this.send({do:"stop",stage:"live"}),this.end();return}let t=R("card");t.hidden?this.send({do:"cards"}):this.send({do:"listen",device:Number(t.value),full_scale:Number(R("full-scale").value)})}cards(e){let t=R("card");t.replaceChildren(...e.map(n=>q("option",{value:String(n.number)},`${n.name}, ${n.channels} channels`))),t.value=String(e.find(n=>n.default)?.number??e[0]?.number??""),t.hidden=e.length===0,e.length?this.turn(!0):this.failed("no device that can record is there")}};function xm(i,e,t){let n=q("canvas",{"aria-hidden":"true"});Ci(n,e,t);let s=n.getContext("2d"),r=[...i.points,...i.microphones.map(([f,p])=>[f,p,2])],[o,a]=[Math.min(...r.map(([f,,p])=>f-p)),Math.max(...r.map(([f,,p])=>f+p))],[c,l]=[Math.min(...r.map(([,f,p])=>f-p)),Math.max(...r.map(([,f,p])=>f+p))],h=.92*Math.min(n.width/(a-o),n.height/(l-c)),u=(f,p)=>[n.width/2+h*(f-(o+a)/2),n.height/2-h*(p-(c+l)/2)];s.strokeStyle=Re("--ink-soft"),s.lineWidth=devicePixelRatio;for(let f of i.lines){s.beginPath();for(let p of f)s.lineTo(...u(i.points[p-1][0],i.points[p-1][1]));s.stroke()}let d=Math.max(i.points.length-1,1);i.points.forEach(([f,p,v],g)=>{s.beginPath(),s.arc(...u(f,p),Math.max(v*h,1.5*devicePixelRatio),0,7),s.fillStyle=Pl(g/d),s.fill()}),s.fillStyle=Re("--good");for(let[f,p]of i.microphones){let[v,g]=u(f,p),m=Math.max(2.4*h,4*devicePixelRatio);s.fillRect(v-m/2,g-m/2,m,m)}return n}var Av="acoustic-fem-recent";function _m(){try{return JSON.parse(localStorage.getItem(Av)??"[]")}catch{return[]}}function Rv(i){let e=_m().filter(t=>t.name!==i.name);try{localStorage.setItem(Av,JSON.stringify([i,...e].slice(0,6)))}catch{}}var Vu=class{constructor(e,t,n){this.send=e;this.open=t;this.prototype=n;R("new").addEventListener("click",()=>{this.dialogue.showModal(),this.words?this.gallery():this.send({do:"job"})}),R("job-close").addEventListener("click",()=>this.dialogue.close()),R("job-place").addEventListener("change",()=>this.usual()),R("job-stop").addEventListener("click",()=>this.send({do:"stop",stage:"proposals"})),R("job-form").addEventListener("submit",s=>{s.preventDefault(),this.ask()})}send;open;prototype;words=null;dialogue=R("job");learn(e){this.words=e;let t=(r,o,a)=>{R(r).replaceChildren(...o.map(([c,l])=>q("option",{value:c},l))),R(r).value=a};t("job-place",Object.entries(e.places).map(([r,o])=>[r,o.title]),"flat"),t("job-printer",Object.entries(e.printers),e.printer);let[n,s]=e.target.split(" ");t("job-contact",e.contacts.map(r=>[r,r]),n),R("job-force").value=s,this.usual(),this.gallery()}progress(e){R("job-progress").textContent=e,R("job-propose").disabled=e!=="",R("job-stop").disabled=e===""}failed(e){this.progress(""),R("job-problem").textContent=e}take(e){this.progress(""),R("job-problem").textContent=e.problem,R("job-found").replaceChildren(...e.designs.map(t=>this.card(t))),R("job-found").querySelector("button")?.focus()}usual(){let e=this.words.places[R("job-place").value],t={points:String(e.points),microphones:String(e.microphones),size:e.size??"any",around:e.around===null?"flat":String(e.around)};for(let[n,s]of Object.entries(t))R(`job-${n}`).placeholder=s;R("job-around").disabled=e.around===null}ask(){let e=n=>R(`job-${n}`).value.trim(),t={};for(let n of["place","points","size","printer"])e(n)&&(t[n]=e(n));for(let n of["microphones","budget","around"]){if(!e(n)||R(`job-${n}`).disabled)continue;let s=Number(e(n).replace(",","."));t[n]=Number.isFinite(s)?s:e(n)}t.target=`${e("contact")} ${e("force")} N`,R("job-problem").textContent="",R("job-found").replaceChildren(),this.send({do:"propose",name:e("name")||"design",asked:t})&&this.progress("begins")}card(e){let t=`${e.strength}: ${e.outcome}`,n=q("dl",{},...e.rows.flatMap(([o,a,c])=>[q("dt",{title:c},o),q("dd",{},br(a))])),s=q("ul",{},...e.reasons.map(o=>q("li",{},br(o)))),r=Ft("Open this design",()=>{this.dialogue.close(),this.open(e.stated,"the proposal")},{class:"pick","aria-label":`open the design that is ${e.strength}`});return q("li",{"data-outcome":e.outcome.replaceAll(" ","-")},q("strong",{},t),xm(e.plan,250,110),q("p",{class:"note"},`${e.points} points`),n,s,r)}gallery(){let e=(s,r,o)=>{let a=Ft("",()=>{this.dialogue.close(),o()},{class:"tile"});return a.append(r,q("span",{},s)),a},t=s=>{let r=q("canvas",{width:"150",height:"84","aria-hidden":"true"}),o=new Image;return o.addEventListener("load",()=>r.getContext("2d").drawImage(o,0,0,150,84)),o.src=s.picture,e(s.name,r,()=>this.open(s.stated,"a recent design"))},n=_m();R("job-recent-title").hidden=n.length===0,R("job-recent").replaceChildren(...n.map(t)),R("job-prototypes").replaceChildren(...Object.entries(this.words.prototypes).map(([s,r])=>e(s,xm(r,150,84),()=>this.prototype(s))))}};var CA=3e3,PA=6e3,IA=1008,Gu=class{constructor(e,t,n,s){this.hello=e;this.text=t;this.binary=n;this.state=s;setInterval(()=>this.watch(),CA),this.open()}hello;text;binary;state;socket=null;asked=0;answered=!0;admitted=!1;tries=0;send(e){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(JSON.stringify(e)),!0)}open(){let e=new WebSocket(`ws://${location.host}/session`);e.binaryType="arraybuffer",this.socket=e,this.answered=!0,this.admitted=!1,e.onopen=()=>{e.send(JSON.stringify({...this.hello(),secret:xd()}))},e.onmessage=t=>{this.admitted||(this.admitted=!0,this.tries=0,this.state("open")),this.answered=!0,typeof t.data=="string"?this.text(JSON.parse(t.data)):this.binary(t.data)},e.onclose=t=>this.lost(e,t.code===IA?"locked":"lost")}watch(){this.socket?.readyState===WebSocket.OPEN&&(this.answered?(this.answered=!1,this.asked=performance.now(),this.send({do:"ping"})):performance.now()-this.asked>PA&&this.lost(this.socket))}lost(e,t="lost"){e===this.socket&&(this.socket=null,e.onclose=e.onmessage=null,e.close(),this.state(t),this.tries+=1,setTimeout(()=>this.again(),Math.min(250*2**this.tries,4e3)))}async again(){try{if((await fetch("/studio.css",{method:"HEAD",cache:"no-store"})).ok)return this.open();this.state("locked")}catch{this.state("gone")}this.tries+=1,setTimeout(()=>this.again(),2e3)}};function Cv(i,e){let t=document.querySelector("[data-problem='touch']"),n=document.querySelector("[data-status='touch']"),s=async o=>{t.textContent="";let a=o.find(h=>h.name.endsWith(".toml")),c=o.find(h=>h!==a);try{a&&(R("full-scale").value=String((await(await Tr("/manifests",{name:a.name},a)).json()).full_scale))}catch(h){t.textContent=h.message;return}if(!c)return;let l={session:e().session,name:c.name,full_scale:R("full-scale").value};R("answer").textContent="the recording is decoded\u2026";try{let h=Eu(await(await Tr("/recordings",l,c)).arrayBuffer());if(h.revision!==e().revision)throw new Error("The design was changed meanwhile: replay the recording again.");i.hear(h)}catch(h){i.failed(),t.textContent=h.message}n.textContent=""},r=async o=>{t.textContent="";try{let a=await rv("/recognizers",{session:e().session},o);R("answer").textContent=`A recognizer of ${a.subject} on ${a.design} recognizes: ${a.labels.join(", ")}.`}catch(a){t.textContent=a.message}};R("replay").addEventListener("change",o=>{let a=o.target,c=[...a.files??[]];c.length&&s(c),a.value=""}),R("recognizer").addEventListener("change",o=>{let a=o.target,c=[...a.files??[]];c.length&&r(c),a.value=""})}var vm=196,LA=60,Wu=2,Pv=34,NA=30,Er=3,Sa=9,DA={"resonator.cavity_diameter":"diameter of the cavity","resonator.cavity_height":"height of the cavity","resonator.wall_thickness":"wall","resonator.floor_thickness":"floor","membrane.thickness":"thickness of the membrane","membrane.rim_width":"rim of the membrane","tube.inner_diameter":"bore of the tube"},Xu=class{constructor(e){this.set=e;for(let[t,n]of Object.entries(DA)){let s=q("input",{type:"text",class:"dimension",inputmode:"decimal",autocomplete:"off","data-dimension":t,"aria-label":`${n}, mm`,title:`${n}, mm: type another one`});s.addEventListener("change",()=>{let r=s.value.replace("\u2212","-").replace(",",".").trim();this.set(t,r===""||!Number.isFinite(Number(r))?s.value:Number(r))}),s.addEventListener("keydown",r=>{r.key==="Escape"&&(this.draw(),s.blur())}),s.addEventListener("blur",()=>this.draw()),this.inputs.set(t,s),R("section-holder").append(s)}new ResizeObserver(()=>this.draw()).observe(R("section-holder"))}set;stated=null;inUse={};inputs=new Map;take(e,t){this.stated=e,t&&(this.inUse=t),this.draw()}draw(){let e=R("section-holder").clientWidth,t=this.stated;if(!t||e===0)return;let n=R("resonator-section"),{resonator:s,membrane:r,tube:o}=t;Ci(n,e,vm);let a=n.getContext("2d");a.scale(devicePixelRatio,devicePixelRatio);let c=(H,Y)=>Y??Number(this.inUse[`resonator.${H}`]??0),l=s.cavity_diameter/2,h=l+s.wall_thickness,u=s.cavity_height,d=-s.floor_thickness,f=u+r.thickness,p=l+r.rim_width,v=Math.max(h,p),g=Math.min((e-2*LA)/(2*(v+Wu)),(vm-Pv-NA)/(f-d)),m=H=>e/2+g*H,y=H=>vm-Pv-g*(H-d),M=(H,Y,B,ce,Z)=>{a.fillStyle=Z,a.fillRect(m(H),y(ce),g*(B-H),g*(ce-Y))},b=Re("--edge"),C=Re("--card");M(-h,d,h,u,b),this.cavity(a,m,y,l,u,C,c);let A=c("port_height",s.port_height),x=o.inner_diameter/2,E=o.outer_diameter/2;for(let H of[-1,1]){let[Y,B]=[H*h,H*(l-.02*l)].sort((ee,se)=>ee-se);M(Y,A-x,B,A+x,C);let[ce,Z]=[H*(h+Wu),H*(l+.4*s.wall_thickness)].sort((ee,se)=>ee-se);M(ce,A-E,Z,A+E,Re("--ink-soft")),M(ce,A-x,Z,A+x,C)}M(-p,u,p,f,Re("--accent")),a.strokeStyle=Re("--ink-soft");let k=y(d)+Sa,D=y(f)-Sa,L=(H,Y,B)=>Iv(a,[[m(H),B,m(Y),B],[m(H),B-Er,m(H),B+Er],[m(Y),B-Er,m(Y),B+Er]]),W=(H,Y,B)=>Iv(a,[[B,y(H),B,y(Y)],[B-Er,y(H),B+Er,y(H)],[B-Er,y(Y),B+Er,y(Y)]]),X=m(-v)-Sa,O=m(v)+Sa;L(-l,l,k),L(-h,-l,k),L(l,p,D),W(d,0,X),W(u,f,O),W(0,u,m(.72*l)),W(A-x,A+x,m(h+Wu)+Sa),this.place("resonator.cavity_diameter",2*l,m(0),k+11),this.place("resonator.wall_thickness",s.wall_thickness,Math.max(m(-(h+l)/2),26),k+11),this.place("membrane.rim_width",r.rim_width,m((l+p)/2),D-10),this.place("resonator.floor_thickness",s.floor_thickness,X-26,y(d/2)),this.place("membrane.thickness",r.thickness,O+26,y((u+f)/2)),this.place("resonator.cavity_height",u,m(.72*l)-26,y(u/2)),this.place("tube.inner_diameter",o.inner_diameter,Math.min(m(h+Wu)+Sa+26,e-24),y(A)),n.setAttribute("aria-label",`section of a resonator: cavity ${Ne(2*l)} mm wide and ${Ne(u)} mm high, wall ${Ne(s.wall_thickness)} mm, floor ${Ne(s.floor_thickness)} mm, membrane ${Ne(r.thickness)} mm`)}place(e,t,n,s){let r=this.inputs.get(e);document.activeElement!==r&&(r.value=Ne(t)),Object.assign(r.style,{left:`${n-22}px`,top:`${s-9}px`})}cavity(e,t,n,s,r,o,a){let{resonator:c}=this.stated;if(e.fillStyle=o,e.beginPath(),c.shape==="box"){let l=a("box_length",c.box_length)/2,h=r-a("collar_height",c.collar_height);for(let[u,d]of[[-s,r],[-s,h],[-l,h],[-l,0],[l,0],[l,h],[s,h],[s,r]])e.lineTo(t(u),n(d))}else if(c.shape==="dome"){let l=a("dome_depth",c.dome_depth),h=(s*s+l*l)/(2*l);e.lineTo(t(-s),n(r));for(let u=-24;u<=24;u++){let d=s*u/24;e.lineTo(t(d),n(h-Math.sqrt(Math.max(h*h-d*d,0))))}e.lineTo(t(s),n(r))}else for(let[l,h]of[[-s,r],[-s,0],[s,0],[s,r]])e.lineTo(t(l),n(h));e.fill()}};function Iv(i,e){i.beginPath();for(let[t,n,s,r]of e)i.moveTo(t,n),i.lineTo(s,r);i.stroke()}function Lv(){let i=document.getElementById("shared");if(!i)return null;let e=JSON.parse(i.textContent);for(let t of document.querySelectorAll("[role=tab][data-live]"))t.remove();for(let t of["fields","section-holder"])R(t).inert=!0;return R("made").hidden=!1,R("made").textContent=`to look at only; made on ${e.about.made} with acoustic-fem ${e.about.version}. Save downloads the design file, which a studio opens.`,e}var qu=class{constructor(e,t,n){this.shared=e;this.curves=n;for(let s of e.messages)t(s)}shared;curves;send(e){if(e.do==="want"){let t=Uint8Array.from(atob(this.shared.curves[e.quantity]),n=>n.charCodeAt(0));this.curves(t.buffer)}else if(e.do==="export"&&e.name==="design.toml")Ti(new Blob([this.shared.toml],{type:"application/toml"}),`${this.shared.messages.find(t=>t.type==="design").design_name}.toml`);else return!1;return!0}};var OA=["predicted_top1","noise_equivalent_force","coverage","length","cost"],ql=220,$u=70,Yu=42,ym=20,UA=9,Ku=class{constructor(e){this.open=e;let t=R("parallel");t.addEventListener("pointermove",n=>{this.point(this.under(n))}),t.addEventListener("pointerleave",()=>this.point(null)),t.addEventListener("click",n=>{let s=this.under(n);s&&this.open(s)}),new ResizeObserver(()=>this.draw()).observe(R("parallel-shown").parentElement)}open;lines=[];now={};word={};chosen=new Set(OA);pointed=null;places=[];learn(e){this.word=e,R("parallel-axes").replaceChildren(...Object.entries(e).map(([t,{title:n,definition:s}])=>{let r=q("input",{type:"checkbox","data-axis":t});return r.checked=this.chosen.has(t),r.addEventListener("change",()=>{r.checked?this.chosen.add(t):this.chosen.delete(t),this.draw()}),q("label",{title:s},r,` ${n}`)}))}take(e,t){this.lines=e,t&&(this.now=t),this.draw()}draw(){let e=Object.keys(this.word).filter(h=>this.chosen.has(h)),t={name:"the design at hand",figures:this.now},n=[...this.lines,t].filter(h=>e.some(u=>Number.isFinite(h.figures[u])));R("parallel-shown").hidden=this.lines.length===0;let s=R("parallel"),r=R("parallel-shown").clientWidth;if(this.places=[],!r||(Ci(s,r,ql),!e.length))return;let o=s.getContext("2d");o.scale(devicePixelRatio,devicePixelRatio),o.font="11px system-ui",o.textAlign="center";let a=h=>e.length===1?r/2:$u+h*(r-2*$u)/(e.length-1),c=e.length===1?r-20:Math.min((r-2*$u)/(e.length-1),2*$u)-8,l=e.map((h,u)=>this.axis(o,n,h,a(u),c));for(let h of n){let u=e.map((p,v)=>Number.isFinite(h.figures[p])?[a(v),l[v](h.figures[p])]:null),d=h===t;o.strokeStyle=o.fillStyle=Re(d?"--accent":"--ink-soft"),o.lineWidth=h===this.pointed?4:2,o.beginPath();let f=!1;for(let p of u)p&&f?o.lineTo(...p):p&&o.moveTo(...p),f=p!==null;o.stroke();for(let p of u)p&&(o.beginPath(),o.arc(p[0],p[1],3.5,0,7),o.fill());d||this.places.push({line:h,at:u.filter(p=>p!==null)})}s.setAttribute("aria-label",`${this.lines.length} snapshots over ${e.map(h=>this.word[h].title).join(", ")}; the list above opens them`)}axis(e,t,n,s,r){let{title:o,unit:a,better:c}=this.word[n],l=t.map(p=>p.figures[n]).filter(Number.isFinite),h=Math.min(...l),u=Math.max(...l);h===u&&([h,u]=[h-Math.abs(h||1)/2,u+Math.abs(u||1)/2]);let[d,f]=c==="smaller"?[u,h]:[h,u];return e.strokeStyle=Re("--edge"),e.lineWidth=1,e.beginPath(),e.moveTo(s,Yu),e.lineTo(s,ql-ym),e.stroke(),e.fillStyle=Re("--ink"),FA(o,r,e).slice(0,2).forEach((p,v)=>e.fillText(p,s,11+12*v,r)),e.fillStyle=Re("--ink-soft"),new Set(l).size===1?e.fillText(Js(Number(l[0].toPrecision(3)),a),s,Yu-6,r):l.length&&(e.fillText(Js(Number(f.toPrecision(3)),a),s,Yu-6,r),e.fillText(Js(Number(d.toPrecision(3)),a),s,ql-6,r)),p=>ql-ym-(p-d)/(f-d)*(ql-ym-Yu)}point(e){if(e===this.pointed)return;this.pointed=e;let t=e&&[...this.chosen].filter(n=>Number.isFinite(e.figures[n])).map(n=>`${this.word[n].title} ${Js(e.figures[n],this.word[n].unit)}`);R("parallel-pointed").textContent=t?`${e.name}: ${t.join(", ")}`:"\xA0",this.draw()}under(e){let t=R("parallel").getBoundingClientRect(),n=e.clientX-t.left,s=e.clientY-t.top,r=null,o=UA;for(let{line:a,at:c}of this.places)for(let l=0;l<c.length;l++){let[h,u]=c[l],[d,f]=c[Math.min(l+1,c.length-1)],p=(d-h)**2+(f-u)**2,v=p?Math.min(Math.max(((n-h)*(d-h)+(s-u)*(f-u))/p,0),1):0,g=Math.hypot(n-h-v*(d-h),s-u-v*(f-u));g<o&&(o=g,r=a)}return r}};function FA(i,e,t){let n=[];for(let s of i.split(" ")){let r=n.at(-1);r!==void 0&&t.measureText(`${r} ${s}`).width<=e?n[n.length-1]=`${r} ${s}`:n.push(s)}return n.length>2?[n[0],n.slice(1).join(" ")]:n}var Nv="acoustic-fem-snapshots",Dv="acoustic-fem project 1",Ov=24,ju=class{constructor(e,t,n){this.open=e;this.pin=t;this.take=n;try{let s=JSON.parse(localStorage.getItem(Nv)??"{}");this.all=s.all??[],R("notes").value=s.notes??""}catch{}R("snapshot").addEventListener("click",()=>this.add(this.take())),R("notes").addEventListener("change",()=>this.keep()),this.draw()}open;pin;take;all=[];parallel=new Ku(e=>this.open(this.all.find(t=>t.name===e.name).stated));save(e,t){let n={kind:Dv,stated:e,pinned:t,snapshots:this.all,notes:R("notes").value};Ti(new Blob([JSON.stringify(n)],{type:"application/json"}),`${e.name}.afem.json`)}read(e){let t=null;try{t=JSON.parse(e)}catch{}if(t?.kind!==Dv||typeof t.stated!="object"||!Array.isArray(t.snapshots))throw new Error("This is not a project file of this studio.");return this.all=t.snapshots.slice(0,Ov),R("notes").value=String(t.notes??""),this.keep(),this.draw(),t}learn(e){this.parallel.learn(e),this.compare()}figured(e,t){let n=JSON.stringify(e),s=this.all.filter(r=>!r.figures&&JSON.stringify(r.stated)===n);for(let r of s)r.figures=t;s.length&&this.keep(),this.compare(t)}restyle(){this.parallel.draw()}compare(e=null){this.parallel.take(this.all.filter(t=>t.figures).map(t=>({name:t.name,figures:t.figures})),e)}add(e){let t=new Set(this.all.map(s=>s.name)),n=e.name;for(let s=2;t.has(n);s++)n=`${e.name} (${s})`;this.all=[{...e,name:n},...this.all].slice(0,Ov),this.keep(),this.draw()}keep(){try{localStorage.setItem(Nv,JSON.stringify({all:this.all,notes:R("notes").value}))}catch{}}draw(){this.compare(),R("snapshots-empty").hidden=this.all.length>0,R("snapshots").replaceChildren(...this.all.map((e,t)=>{let n=q("canvas",{width:"150",height:"84","aria-hidden":"true"}),s=new Image;s.addEventListener("load",()=>n.getContext("2d").drawImage(s,0,0,150,84)),e.picture.startsWith("data:image/")&&(s.src=e.picture);let r=q("input",{type:"text","aria-label":`name of snapshot ${t+1}`});return r.value=e.name,r.addEventListener("change",()=>{e.name=r.value,this.keep(),this.compare()}),q("li",{},n,q("div",{},r,q("p",{class:"note"},[e.outcome,...e.rows.map(([o,a])=>`${o} ${a}`)].filter(Boolean).join(", ")),Ft("Open",()=>this.open(e.stated),{"aria-label":`open ${e.name}`})," ",Ft("Compare",()=>this.pin(e.stated),{"aria-label":`compare with ${e.name}`})," ",Ft("\xD7",()=>{this.all=this.all.filter(o=>o!==e),this.keep(),this.draw()},{"aria-label":`remove ${e.name}`})))}))}};var kA=12,BA=["predicted_top1","volume"],Zu=class{constructor(e,t,n){this.send=e;this.load=t;this.marks=n;R("study-limit-add").addEventListener("change",()=>{let r=R("study-limit-add"),o=r.value;if(r.value="",!o||this.limits.has(o))return;let a=this.marks()[0].value(o);this.limits.set(o,o==="verdict"?"1":typeof a=="number"?String(Number(a.toPrecision(3))):""),this.listLimits(),R("study-limits").querySelector(".study-range:last-child input")?.focus()}),R("study-add").addEventListener("change",()=>{let r=R("study-add"),o=this.fields.find(a=>a.name===r.value);r.value="",o&&this.add(o)}),R("study-run").addEventListener("click",()=>this.ask(!0)),R("study-file").addEventListener("click",()=>this.ask(!1)),R("study-csv").addEventListener("click",()=>this.table()),R("study-png").addEventListener("click",()=>this.now&&zl([...R("study-shown").querySelectorAll("canvas")],`${this.now.title}.png`));for(let r of["study-effect","study-x","study-y"])R(r).addEventListener("change",()=>this.draw());let s=R("study-front");s.addEventListener("click",r=>{let o=this.under(r);o!==null&&this.load(this.now.number[o])}),s.addEventListener("pointermove",r=>{R("study-pointed").textContent=this.said(this.under(r))??this.failure(r)??"\xA0"}),new ResizeObserver(()=>this.draw()).observe(R("study-shown"))}send;load;marks;fields=[];ranges=new Map;now=null;places=[];crosses=[];words={};limits=new Map;learn(e,t,n){R("study-metrics").childElementCount||(R("study-designs").setAttribute("max",String(n)),this.words=e,R("study-limit-add").replaceChildren(q("option",{value:""},"add a limit\u2026"),...Object.entries(e).map(([s,r])=>q("option",{value:s,title:r.definition},r.title))),R("study-metrics").replaceChildren(...Array.from({length:t},(s,r)=>{let o=q("select",{"aria-label":`figure of merit ${r+1}`},...r?[q("option",{value:""},"\u2013")]:[],...Object.entries(e).map(([a,c])=>q("option",{value:a,title:c.definition},c.title)));return o.value=BA[r]??"",o})))}take(e){this.fields=e.filter(n=>n.kind==="number"||n.kind==="count"||n.choices.length||n.suggestions.length);let t=new Map;for(let n of this.fields)t.has(n.group)||t.set(n.group,q("optgroup",{label:n.group||"array"})),t.get(n.group).append(q("option",{value:n.name},n.label));R("study-add").replaceChildren(q("option",{value:""},"add a range\u2026"),...t.values());for(let n of this.ranges.keys())this.fields.some(s=>s.name===n)||this.ranges.delete(n);this.list()}found(e){let t=c=>c&&[c.title,...c.parameters,...c.metrics].map(l=>typeof l=="string"?l:l.name).join(),n=t(this.now)===t(e);this.now=e,R("study-shown").hidden=!1;let s=[...e.parameters,...e.metrics],r=(c,l,h)=>{let u=R(c);n||(u.replaceChildren(...l.map((d,f)=>q("option",{value:String(f)},d.title))),u.value=String(h))};r("study-effect",e.metrics,0),r("study-x",s,e.metrics.length>1?e.parameters.length+1:0),r("study-y",s,e.parameters.length);let o=e.kept.filter(Boolean).length,a=e.failures.reduce((c,[,l])=>c+l,0);R("study-said").textContent=`${e.title}, fidelity ${e.fidelity}: ${e.number.length} designs computed${e.waiting?`, ${e.waiting} not yet: Run goes on`:""}${a?`, ${a} failed (${e.failures.map(([c,l])=>`${l}: ${c}`).join("; ")})`:""}${e.limits.length?`; ${o} keep the limits (${e.limits.join("; ")})`:""}.`,this.draw()}restyle(){this.draw()}add(e){if(this.ranges.has(e.name))return;let t=typeof e.value=="number"?e.value:1,n=e.choices.length?e.choices:e.suggestions,s=r=>{let o=e.kind==="count"?Math.round(t*r):Number((t*r).toPrecision(3));return String(Math.min(Math.max(o,e.lowest??-1/0),e.highest??1/0))};this.ranges.set(e.name,n.length?[n.join(", "),""]:[s(.7),s(1.4)]),this.list(),R("study-ranges").querySelector(".study-range:last-child input")?.focus()}list(){R("study-ranges").replaceChildren(...[...this.ranges].map(([e,t])=>{let n=this.fields.find(c=>c.name===e),s=n.kind==="text",r=(c,l)=>{let h=q("input",{type:"text",class:s?"text":"end","aria-label":`${e}, ${l}`,...s?{}:{inputmode:"decimal"}});return h.value=t[c],h.addEventListener("change",()=>{t[c]=h.value}),h},o=s?[r(0,"values")]:[r(0,"from"),q("span",{},"to"),r(1,"to"),q("span",{class:"unit"},n.unit)],a=Ft("\xD7",()=>{this.ranges.delete(e),this.list()},{"aria-label":`no range for ${e}`});return q("div",{class:"study-range","data-range":e},q("span",{class:"label"},e),...o,a)}))}listLimits(){R("study-limits").replaceChildren(...[...this.limits].map(([e,t])=>{let{title:n,unit:s,better:r,definition:o}=this.words[e],a=`${n} at ${r==="larger"?"least":"most"}`,c=q("input",{type:"text",class:"end","aria-label":a,inputmode:"decimal"});c.value=t,c.addEventListener("change",()=>{this.limits.set(e,c.value)});let l=Ft("\xD7",()=>{this.limits.delete(e),this.listLimits()},{"aria-label":`no limit of ${n}`});return q("div",{class:"study-range","data-limit":e,title:o},q("span",{class:"label"},a),c,q("span",{class:"unit"},s==="1"?"":wi(s)),l)}))}ask(e){let t={},n=r=>{let o=r.replace("\u2212","-").replace(",",".").trim();return o===""||Number.isNaN(Number(o))?r:Number(o)};for(let[r,[o,a]]of this.ranges){let c=this.fields.find(l=>l.name===r).kind==="text";t[r]=c?o.split(",").map(l=>l.trim()).filter(Boolean):[n(o),n(a)]}let s=[...R("study-metrics").querySelectorAll("select")].map(r=>r.value).filter(Boolean);this.send({do:"study",run:e,ranges:t,metrics:[...new Set(s)],search:R("study-kind").value==="search",designs:Number(R("study-designs").value),fidelity:R("study-fidelity").value,limits:Object.fromEntries([...this.limits].map(([r,o])=>[r,n(o)]))})}draw(){let e=this.now,t=R("study-shown").clientWidth;if(!e||t===0)return;let n=Number(R("study-effect").value),s=e.metrics[n],r=Math.min(320,t),o=Bl(e.effects[n].flatMap(a=>[...a.low,...a.high]),s.title,s.unit);R("study-effects").replaceChildren(...e.parameters.map((a,c)=>{let l=e.effects[n][c],h=q("canvas",{role:"img"}),u=`${a.name}: explains ${Ne(100*l.share,2)} % of the variance`;return h.setAttribute("aria-label",`${s.title} over ${u}`),h.dataset.share=String(l.share),this.effect(h,r,l,Bl(a.values,a.title,a.unit,a.labels),o),q("figure",{class:"plot"},h,q("figcaption",{},u))})),this.cloud(t),this.best()}effect(e,t,n,s,r){let{c:o,x:a,y:c}=dm(e,t,200,s,r);if(o.fillStyle=o.strokeStyle=Re("--accent"),n.centres.length>1&&!s.labels.length){o.globalAlpha=.18,o.beginPath(),n.centres.forEach((l,h)=>o.lineTo(a(l),c(n.low[h])));for(let l=n.centres.length-1;l>=0;l--)o.lineTo(a(n.centres[l]),c(n.high[l]));o.fill(),o.globalAlpha=1,o.lineWidth=2,o.beginPath(),n.centres.forEach((l,h)=>o.lineTo(a(l),c(n.mean[h]))),o.stroke()}n.centres.forEach((l,h)=>{s.labels.length&&(o.globalAlpha=.18,o.fillRect(a(l)-12,c(n.high[h]),24,c(n.low[h])-c(n.high[h])),o.globalAlpha=1),bm(o,a(l),c(n.mean[h]),3)})}column(e){let t=Number(R(e).value),n=this.now.parameters.length;return t<n?[this.now.parameters[t],-1]:[this.now.metrics[t-n],t-n]}front(){let e=this.now,[,t]=this.column("study-x"),[,n]=this.column("study-y"),s=e.fronts.find(l=>l.first===t&&l.second===n||l.first===n&&l.second===t);if(s)return s.rows;let{values:r,better:o}=e.metrics[n>=0?n:t>=0?t:0],a=o==="smaller"?-1:1,c=-1;return r.forEach((l,h)=>{e.kept[h]&&(c<0||a*l>a*r[c])&&(c=h)}),c<0?[]:[c]}remark(){this.now&&R("study-shown").clientWidth&&this.cloud(R("study-shown").clientWidth)}cloud(e){let t=this.now,[n]=this.column("study-x"),[s]=this.column("study-y"),r=R("study-front"),o=(M,b)=>{let C=M.value(b.name),A=typeof C=="string"?b.labels.indexOf(C):C;return typeof A=="number"&&A>=0?A:null},a=this.marks().map(M=>({title:M.title,x:o(M,n),y:o(M,s)})).filter(M=>M.x!==null&&M.y!==null),[c,l]=[n,s].map(M=>t.parameters.indexOf(M)),h=c<0&&l<0?[]:t.failed,u=(M,b)=>b<0?null:M.values[b],d=M=>M!==null,f=Bl([...n.values,...a.map(M=>M.x),...h.map(M=>u(M,c)).filter(d)],n.title,n.unit,n.labels),p=Bl([...s.values,...a.map(M=>M.y),...h.map(M=>u(M,l)).filter(d)],s.title,s.unit,s.labels),{c:v,x:g,y:m}=dm(r,Math.min(e,640),340,f,p),y=new Set(this.front());this.places=n.values.map((M,b)=>({row:b,x:g(M),y:m(s.values[b])})),v.fillStyle=v.strokeStyle=Re("--ink-soft");for(let M of this.places)y.has(M.row)||(v.globalAlpha=t.kept[M.row]?.5:.35,bm(v,M.x,M.y,2.5,t.kept[M.row]));v.globalAlpha=1,v.strokeStyle=Re("--bad"),v.lineWidth=1.2,this.crosses=h.map(M=>({failed:M,x:g(u(M,c)??f.low),y:m(u(M,l)??p.low)}));for(let M of this.crosses)zA(v,M.x,M.y,3.5);v.fillStyle=Re("--accent");for(let M of this.places)y.has(M.row)&&bm(v,M.x,M.y,5);v.lineWidth=2,v.font="11px system-ui",v.textBaseline="middle";for(let M of a){let[b,C]=[g(M.x),m(M.y)],A=b>r.clientWidth-90;v.strokeStyle=v.fillStyle=Re("--ink"),v.strokeRect(b-5,C-5,10,10),v.textAlign=A?"right":"left",v.fillText(M.title,b+(A?-9:9),C)}r.dataset.marks=a.map(M=>M.title).join(", "),r.dataset.crosses=String(this.crosses.length),r.setAttribute("aria-label",`${n.values.length} designs, ${s.title} over ${n.title}; ${y.size} on the front, which the table beside lists${this.crosses.length?`; ${this.crosses.length} without figures`:""}`)}best(){let e=this.now,[,t]=this.column("study-y"),n=e.metrics[t>=0?t:0],s=n.better==="smaller"?1:-1,r=[...this.front()].sort((c,l)=>s*(n.values[c]-n.values[l])),o=[...e.metrics,...e.parameters],a=q("tr",{},q("th",{scope:"col"},"design"),...o.map(c=>q("th",{scope:"col"},c.title)));R("study-best").replaceChildren(q("thead",{},a),q("tbody",{},...r.slice(0,kA).map(c=>q("tr",{"data-design":String(e.number[c])},q("td",{},Ft(`${e.number[c]}`,()=>this.load(e.number[c]),{"aria-label":`load design ${e.number[c]}`})),...o.map(l=>q("td",{},l.labels[l.values[c]]??Js(l.values[c],l.unit)))))))}under(e){let t=R("study-front").getBoundingClientRect(),n=e.clientX-t.left,s=e.clientY-t.top,r=null,o=12;for(let a of this.places){let c=Math.hypot(a.x-n,a.y-s);c<o&&(o=c,r=a.row)}return r}failure(e){let t=R("study-front").getBoundingClientRect(),n=e.clientX-t.left,s=e.clientY-t.top,r=this.crosses.find(o=>Math.hypot(o.x-n,o.y-s)<8);return r?`design ${r.failed.number}: ${r.failed.reason}`:null}said(e){if(e===null)return null;let t=[...this.now.metrics,...this.now.parameters];return`design ${this.now.number[e]}: ${t.map(n=>`${n.title} ${n.labels[n.values[e]]??Js(n.values[e],n.unit)}`).join(", ")}`}table(){let e=this.now;if(!e)return;let t=[...e.parameters,...e.metrics];Ji([["design",...t.map(n=>n.unit?`${n.name} (${n.unit})`:n.name)],...e.number.map((n,s)=>[n,...t.map(r=>r.labels[r.values[s]]??r.values[s])])],`${e.title}.csv`)}};function bm(i,e,t,n,s=!0){i.beginPath(),i.arc(e,t,n,0,7),s?i.fill():i.stroke()}function zA(i,e,t,n){i.beginPath();for(let s of[-1,1])i.moveTo(e-n,t-s*n),i.lineTo(e+n,t+s*n);i.stroke()}var Uv="acoustic-fem-panel",Ju=class{constructor(e=()=>{}){this.opened=e;for(let n of this.tabs)n.addEventListener("click",()=>this.open(n.id.slice(4)));R("tab-design").parentElement.addEventListener("keydown",n=>this.key(n));let t=null;try{t=sessionStorage.getItem(Uv)}catch{}t&&document.getElementById(`tab-${t}`)&&this.open(t)}opened;tabs=[...document.querySelectorAll("[role=tab]")];open(e){for(let t of this.tabs){let n=t.id===`tab-${e}`;t.setAttribute("aria-selected",String(n)),t.tabIndex=n?0:-1,R(t.getAttribute("aria-controls")).hidden=!n}document.body.dataset.panel=e,this.opened(e);try{sessionStorage.setItem(Uv,e)}catch{}}key(e){let t={ArrowDown:1,ArrowRight:1,ArrowUp:-1,ArrowLeft:-1}[e.key];if(!t)return;e.preventDefault();let n=this.tabs.findIndex(r=>r.getAttribute("aria-selected")==="true"),s=this.tabs[(n+t+this.tabs.length)%this.tabs.length];this.open(s.id.slice(4)),s.focus()}};var HA=3e5,VA={open:"",lost:"The connection to the studio was lost and is being restored. The design is kept.",gone:"The studio does not answer: it has ended. Start it again with \u201Cacoustic-fem studio\u201D. This page keeps the design and continues with it.",locked:"The studio does not know this browser. Open the address that it printed last in this browser, then this page continues with its design."},Cr=Lv();Cr||ig();var Zl=null,ai=null,Wn="design",Yl=!1,Vi=-1,Sm={},id="level",Ar=[],wa=null,Wv=-1e4,Fv=250,ao=Ou()?.pinned??null,GA=crypto.getRandomValues(new Uint32Array(4)).join("-"),Rr=null,ed=null,td=null,Kl=null,Ma=new Nu(R("fields"),(i,e,t,n)=>Rn({do:"set",name:i,value:e,gesture:t,bought:n})),Pr=new lu(qv),sd=new au(Pr),Rm=i=>Pr.of(i),is=new Tu(R("plots"),()=>Sm,Rm,Im,Nm),li=new ru(R("space"),Rm,WA,Nm,Cr?null:{drag:Rn,resize:(i,e)=>Rn({do:"resize",size:i,value:e})}),Mm={},ws=new Uu(()=>Mm,Rm,Im,Nm),Cm=new ou((i,e)=>{li.light(t=>t.part===i,[{part:i,place:e}]),R("space").scrollIntoView({block:"nearest"})}),Ir=new Iu(li,i=>Cn?.send(i)??!1,()=>Zl),nd=new Vu(i=>Cn?.send(i)??!1,(i,e)=>Rn({do:"restore",values:i,source:e}),i=>Rn({do:"prototype",name:i})),wm=new zu(R("verdict-shown"),i=>Rn({do:"remedy",values:i})),jl=new cu,Ii=new Bu(i=>{document.querySelector("[data-problem='touch']").textContent="",Cn?.send(i)},i=>li.touch(i)),Tm=new Hu(i=>Cn?.send(i),i=>rd({stage:"live",message:i}),()=>Ii.endLive());Cv(Ii,()=>({session:Zl??"",revision:Vi}));var Ta=new Zu(i=>{document.querySelector("[data-problem='study']").textContent="",Cn?.send(i)},i=>Rn({do:"load",number:i}),()=>[{title:"this design",value:i=>(ns.points===Vi?ws.figures[i]:void 0)??Vv(ai,i)},...ao?[{title:"pinned",value:i=>jl.pinned(i)??Vv(ao,i)}]:[]]),Pm=new Xu((i,e)=>Rn({do:"set",name:i,value:e})),Jl=new ju(i=>Rn({do:"restore",values:i,source:"the snapshot"}),i=>Cn?.send({do:"pin",values:i}),()=>({name:Wn,stated:ai,picture:li.thumbnail(),outcome:ns.verdict===Vi?wm.outcome:"",rows:ns.verdict===Vi?wm.rows:[],figures:ns.points===Vi?ws.figures:void 0})),ns={},Qu=new Set,Em=new Set;function Rn(i){if(Wv=performance.now(),JSON.stringify(i).length>HA)return Pi("This text is too long for a design.");let e=Ar.at(-1);i.gesture&&i.gesture===e?.gesture?Ar[Ar.length-1]=i:Ar.push(i),Xv()}function Xv(){!wa&&Ar.length&&Cn?.send(Ar[0])&&(wa=Ar.shift())}function $l(){wa=null,Xv()}function WA(i,e,t){let n=document.body.dataset.panel==="touch"&&!Cr?t(ai?.target?.contact_radius??0):null;n&&Ii.press(n),Im(i,e)}function Im(i,e){e&&Rr!==null&&i!==Rr?Lm(i):Dm(i)}function Lm(i){ed=i,R("other").value=i===null?"":String(i),is.light(Rr,ed)}function Nm(i){i!==td&&(td=i,is.point(i),li.point(i),ws.point(i),sd.show(i??Rr))}function qv(){is.repaint(),li.recolour(),ws.recolour(),sd.redraw(),Kv()}function Dm(i){Rr=i,(i===null||i===ed)&&Lm(null),R("point").value=i===null?"":String(i),sd.show(td??i),is.light(i,ed),ws.light(i),li.light(e=>i!==null&&e.group===`point ${i}`&&e.kind!=="sheath"&&e.kind!=="spring")}function $v(i){switch(i.type){case"words":return YA(i);case"design":return jA(i);case"refused":return Ma.refuse(i.name,i.message,i.allowed,i.mend)||Pi(i.message),Pm.draw(),$l();case"refused-design":return Pi(i.message),$l();case"error":return Pi(i.message),$l();case"moved":return li.follow(i),Ql();case"refused-size":return XA(i),$l();case"progress":return Qs(i.stage,i.line||document.querySelector(`[data-status="${i.stage}"]`)?.dataset.said||"computing\u2026");case"failed":return rd(i);case"figures":return void $A(i);case"pinned":return ao=i.stated,Yv();case"comparison":R("pin").setAttribute("aria-pressed",String(i.pinned!==null)),i.pinned===null&&is.unpin(),jl.take(i);return;case"compared":return jl.figures(i.rows),Ta.remark();case"file":i.stage==="export"&&Zv(""),Ep(i.file);return;case"validity":R("validity-reason").textContent=i.reason,R("solve").hidden=!i.solves;return;case"solved":return Qs("solve","");case"heard":Tm.on&&Ii.hearLive(i.event);return;case"job":return nd.learn(i);case"proposals":return nd.take(i);case"body":return Qs("body",""),void Ir.learn(i);case"fitted":return Qs("fit","");case"cards":return Tm.cards(i.cards);case"refused-export":Pi(i.message)}}function XA({size:i,message:e,nearest:t}){li.refuseSize(i);let n=t===null?[]:[Ft(`Set ${Ne(t)} mm`,()=>Rn({do:"resize",size:i,value:t}),{class:"mend"})];R("size-refusal").replaceChildren(q("span",{},e),...n)}function Qs(i,e){if(i==="proposals")return nd.progress(e);let t=document.querySelector(`[data-status="${i}"]`);t&&(t.textContent=e),i==="fit"&&Ir.progress(e),i==="solve"&&(R("solve").textContent=e?"Stop":"Solve in 3-D"),i==="study"&&(R("study-run").disabled=e!=="",R("study-stop").disabled=e==="")}function rd(i){if(i.stage==="proposals")return nd.failed(i.message);Qs(i.stage,""),i.stage==="touch"&&Ii.failed(),i.stage==="body"&&Ir.failed();let e=i.stage==="curves"?R("curves-note"):document.querySelector(`[data-problem="${i.stage}"]`);e?e.textContent=i.message:Pi(i.message),i.stage==="export"?Zv(i.message):i.stage==="live"?(R("live").setAttribute("aria-pressed","false"),Ii.endLive()):ns[i.stage]=-1,Ql()}function kv(){Pr.isByFigure?qv():sd.redraw()}async function qA(){for(;performance.now()-Wv<Fv||li.isDragged;)await new Promise(i=>setTimeout(i,Fv/2))}var Bv=Promise.resolve();async function $A(i){let{stage:e,found:t}=i;if(i.revision<(ns[e]??-1))return;if(e==="model"){let s=Bv.then(qA).then(()=>li.take(t,i.revision));Bv=s.catch(()=>{});try{await s,ZA()}catch{return rd({stage:e,message:"The array could not be fetched from the studio. Change the design to draw it again."})}}if(e==="points"&&(Pr.take(t),ws.take(t),kv(),i.revision===Vi&&Jl.figured(ai,t.figures),Ta.remark()),e==="as_built"&&(Pr.asBuilt(t),ws.asBuilt(t),kv()),e==="verdict"&&wm.take(t),e==="check"&&Cm.take(t),e==="surface"&&Ii.take(t,i.revision),e==="study"&&Ta.found(t),i.running)return;ns[e]=i.revision,Qs(e,"");let n=document.querySelector(`[data-problem="${e}"]`);n&&(n.textContent=""),document.documentElement.dataset[`shown_${e}`]=String(i.revision),Ql()}function YA(i){Sm=i.curves;let e=R("quantity");e.replaceChildren(...Object.entries(Sm).map(([n,s])=>q("option",{value:n},s))),e.value=id,R("prototypes").replaceChildren(q("option",{value:""},"prototypes\u2026"),...i.prototypes.map(n=>q("option",{},n))),Mm=i.figures,Jl.learn(Mm),i.new&&KA(),Ta.learn(i.metrics,i.most_metrics,i.most_designs),R("exports").replaceChildren(...Object.entries(i.exports).map(([n,s])=>q("li",{},Ft(n,()=>jv(n),{"data-export":n}),q("span",{},` ${s.title}; ${s.takes}`))));let t=i.new&&!Ou()?mm():null;t&&!Kl&&QA(t),Kl=null,od()}function KA(){for(let i of Object.keys(ns))delete ns[i];is.outdate(),Ir.begin(),Qs("fit",""),Tm.on&&rd({stage:"live",message:"The studio was started again: press Live to listen."}),ao&&Cn?.send({do:"pin",values:ao})}function jA(i){if(Zl=i.session,Vi=i.revision,Yl=i.unsaved,i.form)ai=i.stated,Wn=i.design_name,Ma.build(i.form,i.addable,i.removable),Gv(i.form),Ta.take(i.form);else{Ma.settle(),Ma.update(i.values);for(let[e,t]of Object.entries(i.values))JA(ai,e,t);"name"in i.values&&(Wn=i.values.name),Object.keys(i.values).some(e=>e.endsWith(".points"))&&Gv(null)}R("size-refusal").replaceChildren(),Ma.offer(i.sizes),i.hints&&Ma.hint(i.hints.without_effect,i.hints.in_use),Pm.take(ai,i.hints?.in_use??null),Cr||Ir.take(ai),R("name").textContent=Wn,R("unsaved").hidden=!Yl,document.title=`${Yl?"\u25CF ":""}${Wn} \u2013 acoustic-fem studio`,R("undo").disabled=!i.undo,R("redo").disabled=!i.redo,document.documentElement.dataset.revision=String(Vi),Yv(),Ql(),$l()}var zv=0;function ZA(){Cr||(clearTimeout(zv),zv=window.setTimeout(()=>{ns.model===Vi&&Rv({name:Wn,stated:ai,picture:li.thumbnail()})},1e3))}var Hv=0;function Yv(){Cr||(clearTimeout(Hv),Hv=window.setTimeout(()=>gv({session:Zl,stated:ai,unsaved:Yl,pinned:ao}),150))}function Vv(i,e){for(let t of e.split("."))i=i?.[t];return i}function JA(i,e,t){let n=e.split("."),s=n.pop();for(let r of n)if(i=i?.[r],i==null)return;i[s]=t}function Gv(i){let e=(ai?.lines??[]).reduce((n,s)=>n+s.points,0),t=R("point");(t.options.length!==e+1||i)&&(t.replaceChildren(q("option",{value:""},"all points"),...Array.from({length:e},(n,s)=>q("option",{value:String(s+1)},`point ${s+1}`))),R("other").replaceChildren(q("option",{value:""},"\u2013"),...[...t.options].slice(1).map(n=>n.cloneNode(!0))),Pr.size(e),td=null,Dm(Rr!==null&&Rr<=e?Rr:null))}function Ql(){Ap(R("plots"),is.revision!==Vi);for(let[i,e]of[["model","space"],["points","points-shown"],["points","compared-figures"],["points","point-card"],["as_built","as-built-shown"],["verdict","verdict-shown"],["check","print-shown"],["surface","touch-shown"]])Ap(R(e),ns[i]!==Vi&&!(i==="model"&&li.isMoved))}function Kv(){Qu.clear();for(let i of Em)for(let e of i.dataset.stage.split(" "))Qu.add(e);Pr.wantsBuilt&&Qu.add("as_built"),od()}function od(){Cn?.send({do:"want",stages:[...Qu],quantity:id})}function Pi(i,...e){R("notice").replaceChildren(q("span",{},i),...e,Ft("\xD7",()=>{R("notice").hidden=!0},{"aria-label":"close"})),R("notice").hidden=!1}function QA(i){Pi(`\u201C${i.stated?.name}\u201D was not saved when its page was closed.`,Ft("Go on with it",()=>{Rn({do:"restore",values:i.stated,source:"the design that was kept"}),R("notice").hidden=!0}),Ft("Forget it",()=>{xv(),R("notice").hidden=!0}))}function Om(i){document.documentElement.dataset.theme=i,bx(),Pr.legend(),Pm.draw(),R("theme").setAttribute("aria-pressed",String(i==="dark")),is.restyle(),li.restyle(),ws.restyle(),Ii.restyle(),Ta.restyle(),Ir.restyle(),Jl.restyle()}async function eR(i){let e=i.find(s=>hv.test(s.name)),t=i.find(s=>s.name.endsWith(".json")),n=i.find(s=>s!==e&&s!==t)??t;try{if(e&&await Ir.handIn(e),!n)return;let s=[...n.name].slice(0,100).join("");if(n===t){let{stated:c,pinned:l}=Jl.read(await n.text());Rn({do:"restore",values:c,source:s,saved:!0}),l&&Cn?.send({do:"pin",values:l});return}let r=t?JSON.stringify([await n.text(),await t.text()]):null,o={name:n.name,...t?{places:t.name}:{}},a=await(await Tr("/designs",o,r??n)).json();a.note&&Pi(a.note),Rn({do:"restore",values:a.stated,source:s,saved:!0})}catch(s){Pi(s.message)}}function Um(){Cn?.send({do:"export",name:"design.toml"})||Pi("The studio does not answer, so nothing was saved yet. This page keeps the design.")}function jv(i){if(i==="design.toml")return Um();R("stop-export").disabled=!1,document.querySelector("[data-problem='export']").textContent="",Cn?.send({do:"export",name:i,fidelity:R("fidelity").value})}function Zv(i){R("stop-export").disabled=!0,Qs("export",""),document.querySelector("[data-problem='export']").textContent=i}function Jv(i){let e=Eu(i);if(e.stage==="touch"){e.revision===Vi?Ii.hear(e):Ii.failed();return}e.quantity===id&&(is.take(e),R("curves-note").textContent="",Ql())}var Cn=null,tR=()=>new Gu(()=>{let i=Kl?{session:null,stated:Kl,unsaved:!0}:ai?{session:Zl,stated:ai,unsaved:Yl}:Ou();return["set","restore","prototype","load"].includes(wa?.do)&&Ar.unshift(wa),wa=null,{do:"hello",page:GA,session:i?.session??null,values:i?.stated??null,saved:i?!i.unsaved:!1}},$v,Jv,i=>{R("lost").hidden=i==="open",R("lost").textContent=VA[i],document.body.classList.toggle("away",i!=="open")});R("undo").addEventListener("click",()=>Rn({do:"undo"}));R("redo").addEventListener("click",()=>Rn({do:"redo"}));R("save").addEventListener("click",Um);R("project").addEventListener("click",()=>Jl.save(ai,ao));R("pin").addEventListener("click",()=>Cn?.send({do:"pin",on:R("pin").getAttribute("aria-pressed")!=="true"}));R("address").addEventListener("click",async()=>{let i=await vv(ai);try{await navigator.clipboard.writeText(i),Pi("The address of this design was copied. It opens in a browser that has opened this studio before.")}catch{Pi(i)}});R("theme").addEventListener("click",()=>{let i=document.documentElement.dataset.theme==="dark"?"light":"dark";localStorage.setItem("acoustic-fem-theme",i),Om(i)});R("quantity").addEventListener("change",i=>{id=i.target.value,od()});R("point").addEventListener("change",i=>{let e=i.target.value;Dm(e?Number(e):null)});R("other").addEventListener("change",i=>Lm(Number(i.target.value)||null));R("prototypes").addEventListener("change",i=>{let e=i.target;e.value&&Rn({do:"prototype",name:e.value}),e.value=""});R("open").addEventListener("change",i=>{let e=[...i.target.files??[]];e.length&&eR(e),i.target.value=""});R("curves-csv").addEventListener("click",()=>is.table(Wn));R("curves-png").addEventListener("click",()=>is.picture(Wn));document.addEventListener("keydown",i=>{if(!(i.ctrlKey||i.metaKey)||i.altKey)return;let e=i.key.toLowerCase(),t=i.target instanceof HTMLInputElement&&i.target.type==="text"&&i.target.value!==i.target.dataset.shown;if(e==="s")i.preventDefault(),Um();else{if(t)return;e==="z"&&!i.shiftKey?(i.preventDefault(),Rn({do:"undo"})):(e==="y"||e==="z"&&i.shiftKey)&&(i.preventDefault(),Rn({do:"redo"}))}});async function Qv(){try{return await yv()}catch{return Pi("The address does not hold a readable design. It may have been cut off."),null}}window.addEventListener("hashchange",async()=>{let i=await Qv();i&&Rn({do:"restore",values:i,source:"the address"})});var Am=matchMedia("(prefers-color-scheme: dark)");Om(localStorage.getItem("acoustic-fem-theme")??(Am.matches?"dark":"light"));Am.addEventListener("change",()=>{localStorage.getItem("acoustic-fem-theme")||Om(Am.matches?"dark":"light")});R("points-png").addEventListener("click",()=>ws.picture(Wn));R("points-csv").addEventListener("click",()=>ws.table(Wn));R("print-png").addEventListener("click",()=>fm(Cm.rows(),`${Wn}-print.png`));R("print-csv").addEventListener("click",()=>Ji(Cm.rows(),`${Wn}-print.csv`));R("compare-page").addEventListener("click",()=>jv("comparison.html"));R("compare-png").addEventListener("click",()=>fm(jl.rows(),`${Wn}-compare.png`));R("compare-csv").addEventListener("click",()=>Ji(jl.rows(),`${Wn}-compare.csv`));R("stop-check").addEventListener("click",()=>{Cn?.send({do:"stop",stage:"check"}),Qs("check","stopped")});R("stop-export").addEventListener("click",()=>Cn?.send({do:"stop",stage:"export"}));R("study-stop").addEventListener("click",()=>Cn?.send({do:"stop",stage:"study"}));R("solve").addEventListener("click",()=>{document.querySelector("[data-problem='solve']").textContent="",Cn?.send(R("solve").textContent==="Stop"?{do:"stop",stage:"solve"}:{do:"solve"})});R("sound").addEventListener("click",()=>Ii.sound());R("touch-png").addEventListener("click",()=>Ii.picture(Wn));R("touch-csv").addEventListener("click",()=>Ii.table(Wn));for(let i of document.querySelectorAll("main section, aside section"))for(let e of i.querySelectorAll("button[id$='-png'], button[id$='-csv'], button[id^='stop-']"))e.setAttribute("aria-label",`${e.textContent}, ${i.querySelector("h2").textContent}`);R("array-png").addEventListener("click",()=>li.picture(Wn));new Ju(i=>Ir.opened(i==="body"));var nR=new IntersectionObserver(i=>{for(let e of i)e.isIntersecting?Em.add(e.target):Em.delete(e.target);Kv()},{rootMargin:"100px"});for(let i of document.querySelectorAll("[data-stage]"))nR.observe(i);(async()=>{if(Cr)return Cn=new qu(Cr,$v,Jv),od();Kl=await Qv(),Cn=tR()})();})();
