#lang racket/base
;; Pages measured in a browser: Chromium without a window, where it is installed.  The page is
;; put into a frame of the width asked for, and a script beside it, not in it, measures.

(require json
         racket/file
         racket/port
         racket/string)

(provide browser?
         measure)      ; (measure folder files width expression) -> results in their order

(define program
  (for/or ([name (in-list '("chromium" "chromium-browser" "google-chrome"))])
    (find-executable-path name)))

(define (browser?) (and program #t))

;; files : names in the folder, where a page of measurement is made for a moment
;; expression : of JavaScript, of `d`, the document, and `w`, its window
(define (measure folder files width expression)
  (define page (build-path folder "measure.html"))
  (dynamic-wind
   (lambda () (write-page page files width expression))
   (lambda () (read-results (page-after page)))
   (lambda () (delete-file page))))

(define (write-page page files width expression)
  (display-to-file
   #:exists 'truncate
   (string-append
    "<!DOCTYPE html><meta charset='utf-8'>"
    (string-append*
     (for/list ([f (in-list files)])
       (format "<iframe src='~a' width='~a' height='800' style='border:0'></iframe>" f width)))
    "<pre id='results'></pre><script>\nwindow.onload = async function () {\n"
    "  const found = [];\n"
    "  for (const f of document.querySelectorAll('iframe')) {\n"
    "    const w = f.contentWindow, d = f.contentDocument;\n"
    "    await d.fonts.ready;\n"
    "    found.push(" expression ");\n  }\n"
    "  document.getElementById('results').textContent ="
    " 'RESULTS' + JSON.stringify(found) + 'END';\n"
    "};</script>")
   page))

;; The page's elements when its script has run.
(define (page-after page)
  (define home (make-temporary-file "browser~a" 'directory))
  (define-values (process out in err)
    (subprocess #f #f (open-output-file "/dev/null" #:exists 'append) program
                "--headless" "--no-sandbox" "--hide-scrollbars" "--disable-gpu"
                "--allow-file-access-from-files" "--virtual-time-budget=60000" "--dump-dom"
                (format "--user-data-dir=~a" home) (format "file://~a" page)))
  (close-output-port in)
  (begin0 (port->string out)
          (close-input-port out)
          (subprocess-wait process)
          (delete-directory/files home #:must-exist? #f)))

(define (read-results text)
  (define m (regexp-match #rx"RESULTS([^<]*)END</pre>" text))
  (and m (string->jsexpr (string-replace (cadr m) "&amp;" "&"))))
