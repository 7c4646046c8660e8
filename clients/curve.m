function curve(server)
% A curve from an address, with Octave 7 or MATLAB: curve, or curve('http://127.0.0.1:8080').
    if nargin < 1
        server = 'http://127.0.0.1:8080';
    end

    address = [server '/v1/slip-sweep?wheel.preset=letter&soil.preset=letter-sand&soil.cohesion_pa=200' ...
        '&slip.from=0&slip.to=1&slip.points=101&normal_load_n=80'];
    answer = jsondecode(webread(address, weboptions('ContentType', 'text')));
    disp([answer.columns.slip(1:20:end), answer.columns.longitudinal_force_n(1:20:end)]);

    % From here on the example is checked. The curve is the one that a POST answers with, and carries the load. curl posts,
    % because Octave's webwrite sends forms only; in MATLAB, webwrite(address, body) posts a structure as JSON.
    body.wheel.preset = 'letter';
    body.soil = struct('preset', 'letter-sand', 'cohesion_pa', 200);
    body.slip = struct('from', 0, 'to', 1, 'points', 101);
    body.normal_load_n = 80;
    [status, text] = system(['curl -sS --fail-with-body -H "Content-Type: application/json" -d ''' ...
        jsonencode(body) ''' ' server '/v1/slip-sweep']);
    assert(status == 0, text);
    posted = jsondecode(text);
    assert(numel(answer.columns.slip) == 101);
    assert(isequal(answer.columns, posted.columns));
    assert(max(abs(answer.columns.normal_force_n - 80)) < 1e-6);

    % At 20 mm and 20 % slip: an independent integration of the stresses over 401 000 points, rounded to the digits given.
    address = [server '/v1/forces?wheel.preset=letter&soil.preset=letter-sand&slip=0.2&sinkage_m=0.02'];
    forces = jsondecode(webread(address, weboptions('ContentType', 'text')));
    assert(abs(forces.longitudinal_force_n - 16.906) < 5e-4);
    assert(abs(forces.normal_force_n - 89.716) < 5e-4);
    assert(abs(forces.torque_n_m - 7.3396) < 5e-5);
end
